// One point and many points of PM4Sand: defaults, the first call, invariants, robustness.
#include "solver/pm4sand/pm4sand_arrays.hpp"
#include "solver/pm4sand/pm4sand_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace quicksand {
namespace {

Pm4Sand sand_of(double density)
{
    Pm4Sand law;
    law.relative_density = density;
    return complete(law);
}

Pm4SandState state_of(double sigma_x, double sigma_y, double tau)
{
    Pm4SandState state;
    state.sigma_x = state.sigma_z = sigma_x;
    state.sigma_y = sigma_y;
    state.tau_xy = tau;
    return state;
}

TEST(Pm4Sand, HasThePublishedDefaults)
{
    const Pm4Sand loose = sand_of(0.35), medium = sand_of(0.55), dense = sand_of(0.75);
    EXPECT_NEAR(loose.shear_coefficient, 476.0, 0.5); // of the report's examples
    EXPECT_NEAR(medium.shear_coefficient, 677.0, 0.5);
    EXPECT_NEAR(dense.shear_coefficient, 890.0, 0.5);
    EXPECT_DOUBLE_EQ(loose.modulus_ratio, 0.3);
    EXPECT_DOUBLE_EQ(medium.modulus_ratio, 0.4);
    EXPECT_DOUBLE_EQ(loose.strain_accumulation, 0.5);
    EXPECT_NEAR(dense.strain_accumulation, 0.2, 1e-12);
    EXPECT_NEAR(loose.rotated_dilatancy, 5.0, 1e-12);
    EXPECT_NEAR(dense.rotated_dilatancy, 10.0, 1e-12);
    EXPECT_DOUBLE_EQ(sand_of(0.9).static_shear_factor, 35.0);
    EXPECT_NEAR(medium.critical_ratio, 2.0 * std::sin(33.0 * std::acos(-1.0) / 180.0), 1e-12);
}

TEST(Pm4Sand, LeavesGivenParametersOfTheCalibratedSetAlone)
{
    Pm4Sand law = calibrated_pm4sand();
    law.n1_60 = 12.0;
    const Pm4Sand by_default = complete_calibrated(law);
    EXPECT_NEAR(by_default.modulus_ratio, std::sqrt(12.0 / 46.0) + 0.11, 1e-12);
    EXPECT_EQ(by_default.yield_radius, 0.005);
    EXPECT_NEAR(by_default.bounding_exponent, 0.8 - 1.5 * (std::sqrt(12.0 / 46.0) - 0.35), 1e-12);
    EXPECT_LT(by_default.contraction_rate, contraction_rate_at(by_default.relative_density));
    EXPECT_EQ(by_default.shear_coefficient, complete({.n1_60 = 12.0}).shear_coefficient);
    law.modulus_ratio = 0.5;
    law.contraction_rate = 0.6;
    law.bounding_exponent = 0.3;
    EXPECT_EQ(complete_calibrated(law).modulus_ratio, 0.5);
    EXPECT_EQ(complete_calibrated(law).bounding_exponent, 0.3);
    EXPECT_EQ(complete_calibrated(law).contraction_rate, 0.6);
}

TEST(Pm4Sand, BringsAStressOutsideItsSurfacesBackInTheFirstCall)
{
    const Pm4Sand law = sand_of(0.55);
    Pm4SandState inside = state_of(50e3, 100e3, 10e3), outside = state_of(5e3, 100e3, 0.0);
    EXPECT_FALSE(begin_shaking(law, inside));
    EXPECT_DOUBLE_EQ(inside.alpha_x, -25.0 / 75.0);
    EXPECT_DOUBLE_EQ(inside.alpha_y, 10.0 / 75.0);
    EXPECT_TRUE(begin_shaking(law, outside));
    const double p = 0.5 * (outside.sigma_x + outside.sigma_y);
    EXPECT_NEAR(p, 52.5e3, 1e-9 * p);
    EXPECT_NEAR((outside.sigma_y - outside.sigma_x) / p, largest_ratio(law, p, outside.void_ratio), 1e-12);
}

/// A small strain inside the yield surface: K and G by Poisson's ratio.
TEST(Pm4Sand, IsElasticInsideItsYieldSurface)
{
    const Pm4Sand law = sand_of(0.55);
    Pm4SandState state = state_of(100e3, 100e3, 0.0);
    begin_shaking(law, state);
    const double G = shear_modulus(law, state);
    EXPECT_NEAR(G, law.shear_coefficient * 100e3, 1e-9 * G);
    update(law, {0.0, 1e-9, 2e-9}, state);
    EXPECT_NEAR(state.tau_xy, 2e-9 * G, 1e-6 * 2e-9 * G);
    const double M = G * (law.bulk_over_shear + 4.0 / 3.0);
    EXPECT_NEAR(state.sigma_y - 100e3, 1e-9 * M, 1e-5 * 1e-9 * M);
    EXPECT_NEAR(state.sigma_x - 100e3, 1e-9 * M * 0.3 / 0.7, 1e-5 * 1e-9 * M);
}

/// Undrained shear to large strain ends where M^d = M^b = M, on the critical state line of the void ratio.
TEST(Pm4Sand, EndsInTheCriticalStateOfItsVoidRatio)
{
    for (const double density : {0.25, 0.35, 0.45}) {
        const Pm4Sand law = sand_of(density);
        Pm4SandState state = state_of(100e3, 100e3, 0.0);
        begin_shaking(law, state);
        for (int k = 0; k < 30000; ++k) update(law, {0.0, 0.0, 5e-5}, state);
        const double p = 0.5 * (state.sigma_x + state.sigma_y);
        const double q = 2.0 * std::hypot(0.5 * (state.sigma_x - state.sigma_y), state.tau_xy);
        const double critical = 1e3 * std::exp(law.bolton_q - law.bolton_r / density); // Pa/100 exp(Q - R/Dr)
        EXPECT_NEAR(q / p, law.critical_ratio, 0.02 * law.critical_ratio) << density;
        EXPECT_NEAR(std::log(p / critical), 0.0, 0.3) << density;
    }
}

/// A quarter turn of the axes and of all that is remembered: the components of the law change their signs,
/// and a strain that turns with them gives the same.
TEST(Pm4Sand, IsTheSameAfterAQuarterTurn)
{
    const Pm4Sand law = sand_of(0.55);
    Pm4SandState state = state_of(50e3, 100e3, 10e3), turned = state_of(100e3, 50e3, -10e3);
    state.sigma_z = turned.sigma_z = 50e3;
    begin_shaking(law, state);
    begin_shaking(law, turned);
    for (int k = 0; k < 500; ++k) {
        const double shear = std::sin(0.05 * k) * 2e-5;
        update(law, {1e-7, 2e-6, shear}, state);
        update(law, {2e-6, 1e-7, -shear}, turned);
    }
    EXPECT_NEAR(state.sigma_x, turned.sigma_y, 1e-6 * state.sigma_x);
    EXPECT_NEAR(state.sigma_y, turned.sigma_x, 1e-6 * state.sigma_y);
    EXPECT_NEAR(state.tau_xy, -turned.tau_xy, 1e-6 * state.sigma_y);
}

// alpha_in begins at zero, on neither side. Sand that was sheared to one side first and then rippled on the
// other began there at another place than in the mirror.
TEST(Pm4Sand, IsTheSameInAMirror)
{
    const Pm4Sand law = sand_of(0.5);
    Pm4SandState state = state_of(50e3, 100e3, -500.0), mirrored = state_of(50e3, 100e3, 500.0);
    begin_shaking(law, state);
    begin_shaking(law, mirrored);
    for (const int leg : {200, -600, 100, -200, 100, -300, 900, -100, 300}) {
        for (int k = 0; k < std::abs(leg); ++k) {
            const double shear = leg > 0 ? 1e-6 : -1e-6;
            update(law, {0.0, 0.0, shear}, state);
            update(law, {0.0, 0.0, -shear}, mirrored);
        }
    }
    EXPECT_EQ(state.sigma_y, mirrored.sigma_y);
    EXPECT_EQ(state.tau_xy, -mirrored.tau_xy);
    EXPECT_EQ(state.start_y, -mirrored.start_y);
}

/// Half the tolerance in a substep gives a quarter less: the ends converge with the tolerance.
TEST(Pm4Sand, ErrsLessWithATighterTolerance)
{
    const auto end_at = [](double tolerance) {
        Pm4Sand law = sand_of(0.55);
        law.stress_tolerance = tolerance;
        Pm4SandState state = state_of(50e3, 100e3, 0.0);
        begin_shaking(law, state);
        for (int k = 0; k < 40; ++k) update(law, {0.0, 0.0, (k / 10) % 2 == 0 ? 1e-4 : -1e-4}, state);
        return state.sigma_y;
    };
    const double exact = end_at(1e-7);
    const double coarse = std::abs(end_at(1e-2) - exact), fine = std::abs(end_at(1e-4) - exact);
    EXPECT_LT(fine, 0.1 * coarse + 1e-5 * exact);
    EXPECT_LT(fine, 1e-3 * exact);
}

/// Ten cycles of simple shear to 1 %, which leave sand of 2 kPa whose yield surface is 8 Pa wide, in steps of
/// 1.6e-4: a hundred times the strain in which the direction of flow turns. Measured: 0.3 % of the stress of
/// liquefied sand, 7 % with directions taken at the ends of substeps.
TEST(Pm4Sand, FollowsLiquefiedSandInLongSteps)
{
    constexpr int cycles = 10, steps = 400; // of a cycle
    const auto path_at = [&](double tolerance) {
        Pm4Sand law = sand_of(0.55);
        law.stress_tolerance = tolerance;
        Pm4SandState state = state_of(50e3, 100e3, 0.0);
        begin_shaking(law, state);
        std::vector<double> stresses;
        double strain = 0.0;
        for (int k = 1; k <= cycles * steps; ++k) {
            const double next = 0.01 * std::sin(2.0 * std::numbers::pi * k / steps);
            update(law, {0.0, 0.0, next - strain}, state);
            strain = next;
            if (k > cycles * steps / 2)
                stresses.insert(stresses.end(), {state.tau_xy, 0.5 * (state.sigma_x + state.sigma_y)});
        }
        return stresses;
    };
    const std::vector<double> exact = path_at(1e-6), stresses = path_at(1e-3);
    double squares = 0.0, differences = 0.0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
        squares += exact[k] * exact[k];
        differences += (stresses[k] - exact[k]) * (stresses[k] - exact[k]);
    }
    EXPECT_LT(std::sqrt(differences / squares), 5e-3);
}

class RandomStrains {
public:
    Pm4SandStrain next()
    {
        if (uniform_(random_) < 0.05)
            direction_ = {normal_(random_), normal_(random_), 2.0 * normal_(random_)};
        const double size = uniform_(random_) < 0.999 ? std::pow(10.0, -8.0 + 4.5 * uniform_(random_)) : 0.05;
        const double volume = uniform_(random_) < 0.7 ? -0.5 * (direction_.x + direction_.y) : 0.0;
        return {size * (direction_.x + volume), size * (direction_.y + volume), size * direction_.shear};
    }

private:
    std::mt19937 random_{7};
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
    std::normal_distribution<double> normal_;
    Pm4SandStrain direction_{0.0, 0.0, 1.0};
};

/// Call `look(state)` after each of many strains from twenty stresses; every third is `factor` times as
/// large.
template <class Look>
void strain_at_random(double factor, Look&& look)
{
    const Pm4Sand law = sand_of(0.55);
    RandomStrains strains;
    for (int path = 0; path < 20; ++path) {
        Pm4SandState state = state_of(5e3 * (1 + path), 10e3 * (1 + path), 1e3 * path);
        begin_shaking(law, state);
        for (int k = 0; k < 300; ++k) {
            SCOPED_TRACE(std::to_string(path) + " " + std::to_string(k));
            const Pm4SandStrain next = strains.next();
            const double size = k % 3 == 0 ? factor : 1.0;
            update(law, {size * next.x, size * next.y, size * next.shear}, state);
            look(state);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

TEST(Pm4Sand, StaysFiniteAndAboveItsFloorUnderRandomStrains)
{
    strain_at_random(1.0, [](const Pm4SandState& state) {
        const double p = 0.5 * (state.sigma_x + state.sigma_y);
        ASSERT_TRUE(std::isfinite(p + state.tau_xy + state.sigma_z + state.fabric_path));
        ASSERT_GE(p, 0.2 * state.least_stress * (1.0 - 1e-9));
        ASSERT_LE(std::hypot(state.fabric_x, state.fabric_y),
                  state.fabric_limit / std::numbers::sqrt2 * (1.0 + 1e-9));
    });
}

/// Steps of grains that are thrown about: the shear stress does not outlive the mean stress, nor the back
/// stress.
TEST(Pm4Sand, BearsNoTensionAfterLargeStrains)
{
    strain_at_random(100.0, [](const Pm4SandState& state) {
        const double p = 0.5 * (state.sigma_x + state.sigma_y);
        const double half_q = std::hypot(0.5 * (state.sigma_x - state.sigma_y), state.tau_xy);
        ASSERT_LE(half_q, 1.01 * p); // elastic within the yield surface
        ASSERT_LE(std::hypot(state.alpha_x, state.alpha_y), 1.1);
    });
}

/// In blocks of lanes, alone, and in another order: the same bits.
TEST(Pm4Sand, GivesAPointTheSameBitsInABlockAndAlone)
{
    const Pm4Sand law = sand_of(0.55);
    constexpr std::size_t count = 21;
    Particles together;
    resize(together, count, std::nullopt);
    add_memory(together, memory_of(law).size());
    for (std::size_t p = 0; p < count; ++p) {
        const double vertical = 20e3 * static_cast<double>(1 + p);
        together.stress.yy[p] = -vertical;
        together.stress.xx[p] = together.stress.zz[p] = -0.5 * vertical;
    }
    EXPECT_EQ(start_memory(law, 0, count, together), 0U);
    Particles alone = together;
    for (int k = 0; k < 60; ++k) {
        for (std::size_t p = 0; p < count; ++p)
            together.velocity_gradient_solid.xy[p] =
                (k / 15 % 2 == 0 ? 3e-5 : -3e-5) * static_cast<double>(1 + p % 5);
        alone.velocity_gradient_solid = together.velocity_gradient_solid;
        update_stress(law, 1.0, 0, count, together);
        for (std::size_t p = 0; p < count; ++p) update_stress(law, 1.0, p, p + 1, alone);
    }
    const auto same = [](const auto& a, const auto& b) {
        return std::memcmp(a.data(), b.data(), count * sizeof(double)) == 0;
    };
    EXPECT_TRUE(same(together.stress.xx, alone.stress.xx) && same(together.stress.yy, alone.stress.yy));
    EXPECT_TRUE(same(together.stress.zz, alone.stress.zz) && same(together.stress.xy, alone.stress.xy));
    for (std::size_t k = 0; k < together.memory.size(); ++k)
        EXPECT_TRUE(same(together.memory[k], alone.memory[k])) << memory_of(law)[k].name;
}

} // namespace
} // namespace quicksand
