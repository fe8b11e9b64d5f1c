// What must not matter to elastic, saturated soil on a slanted base: mirrored, and scaled by 50; and its
// momentum.
#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace quicksand {
namespace {

using namespace fixtures;

/// A slope on rock that falls, lengths multiplied by `scale`, mirrored about x = 0 where asked.
std::vector<NamedCorner> rock_slope(double scale, bool mirrored)
{
    std::vector<NamedCorner> corners = {{{0.0, 0.0}, "rock"},   {{6.0, -0.45}, "right"},
                                        {{6.0, 1.0}, "ground"}, {{4.0, 1.0}, "ground"},
                                        {{1.7, 2.1}, "ground"}, {{0.0, 2.1}, "left"}};
    for (NamedCorner& corner : corners) corner.place *= scale;
    if (!mirrored) return corners;
    std::vector<NamedCorner> image;
    for (std::size_t k = corners.size(); k-- > 0;) { // counter-clockwise again: each edge ends where it began
        const std::size_t before = (k + corners.size() - 1) % corners.size();
        image.push_back({{-corners[k].place.x(), corners[k].place.y()}, corners[before].edge});
    }
    return image;
}

/// Stresses scale with lengths, times with their square roots, conductivities too.
std::string tables(double scale, const std::string& scheme)
{
    const auto text = [](double value) {
        std::ostringstream stream;
        stream.precision(17);
        stream << value;
        return stream.str();
    };
    return "[analysis]\nscheme = \"" + scheme +
           "\"\n[sampling]\nparticles_per_cell = [2, 2]\n[water]\nlevel = " + text(3.0 * scale) +
           "\nbulk_modulus = " + text(1e8 * scale) +
           "\n[materials.soil]\nmodel = \"linear_elastic\"\nshear_modulus = " + text(4e6 * scale) +
           "\npoisson_ratio = 0.3\nporosity = 0.4\nhydraulic_conductivity = " +
           text(1e-3 * std::sqrt(scale)) +
           "\n[regions.soil]\nmaterial = \"soil\"\n[boundaries.rock]\nsoil = "
           "\"fixed\"\n[boundaries.left]\nsoil "
           "= \"roller\"\n[boundaries.right]\nsoil = \"roller\"\n[boundaries.ground]\nsoil = \"free\"\n"
           "[initial]\nexcess_pore_pressure = " +
           text(5e3 * scale) + "\n";
}

struct ParticleOutcome {
    Vector2 place = Vector2::Zero(); // at the reference, of the unscaled slope that is not mirrored [m]
    Vector2 displacement = Vector2::Zero();
    double pressure = 0.0;
};

/// The particles after the excess pressure has worked on the slope, in an order that the drawing gives.
std::vector<ParticleOutcome> outcomes(double scale, bool mirrored, const std::string& scheme)
{
    const double h = 0.2 * scale;
    const Vector2 origin(mirrored ? -6.6 * scale : -0.6 * scale, -1.04 * scale);
    AssembledCase assembled = assemble(scene_with(h, origin, 36, 18, tables(scale, scheme)),
                                       polygon_section(rock_slope(scale, mirrored)));
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    run(assembled.problem, 0.05 * std::sqrt(scale), {}, state);
    const double sign = mirrored ? -1.0 : 1.0;
    std::vector<ParticleOutcome> all;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 from = state.particles.reference_position[p] / scale;
        const Vector2 moved = (state.particles.position[p] - state.particles.reference_position[p]) / scale;
        all.push_back({{sign * from.x(), from.y()},
                       {sign * moved.x(), moved.y()},
                       state.particles.pore_pressure[p] / scale});
    }
    std::sort(all.begin(), all.end(), [](const ParticleOutcome& a, const ParticleOutcome& b) {
        const auto key = [](const ParticleOutcome& o) {
            return std::pair(std::lround(1e6 * o.place.x()), std::lround(1e6 * o.place.y()));
        };
        return key(a) < key(b);
    });
    return all;
}

void expect_equal(const std::vector<ParticleOutcome>& a, const std::vector<ParticleOutcome>& b,
                  const std::string& what)
{
    ASSERT_EQ(a.size(), b.size()) << what;
    double farthest = 0.0, highest = 0.0, apart = 0.0, pressure_apart = 0.0, misplaced = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        farthest = std::max(farthest, a[k].displacement.norm());
        highest = std::max(highest, std::abs(a[k].pressure));
        misplaced = std::max(misplaced, (a[k].place - b[k].place).norm());
        apart = std::max(apart, (a[k].displacement - b[k].displacement).norm());
        pressure_apart = std::max(pressure_apart, std::abs(a[k].pressure - b[k].pressure));
    }
    EXPECT_LT(misplaced, 1e-9) << what;
    EXPECT_LT(apart, 1e-6 * farthest) << what;         // measured 3e-11
    EXPECT_LT(pressure_apart, 1e-6 * highest) << what; // 7e-10
}

TEST(Slope, KeepsItsMomentumWithWallsAndSlivers)
{
    for (const std::string scheme : {"explicit", "semi_implicit"}) {
        AssembledCase assembled = assemble(scene_with(0.2, {-0.6, -1.04}, 36, 18, tables(1.0, scheme)),
                                           polygon_section(rock_slope(1.0, false)));
        State& state = assembled.state;
        EXPECT_FALSE(assembled.problem.cut_domains.slivers.empty());
        begin_shaking(assembled.problem, state);
        open_balances(assembled.problem, state);
        const double time = 0.05;
        run(assembled.problem, time, {}, state);
        const Monitors sums = monitor(assembled.problem, state, {});
        const double weight = (sums.mass_solid + sums.mass_fluid) * assembled.problem.gravity; // [N/m]
        const BalanceErrors errors = balance(assembled.problem, state);
        EXPECT_LT(std::abs(errors.momentum_error_x), 1e-12 * weight * time) << scheme;
        EXPECT_LT(std::abs(errors.momentum_error_y), 1e-12 * weight * time) << scheme;
    }
}

TEST(Slope, MirroredOrScaledMovesAlike)
{
    for (const std::string scheme : {"explicit", "semi_implicit"}) {
        const std::vector<ParticleOutcome> drawn = outcomes(1.0, false, scheme);
        expect_equal(drawn, outcomes(1.0, true, scheme), scheme + ", mirrored");
        expect_equal(drawn, outcomes(50.0, false, scheme), scheme + ", scaled");
    }
}

} // namespace
} // namespace quicksand
