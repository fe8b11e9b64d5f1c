// UBCSAND with the calibrated factors: closed forms of its parts, and published numbers of the whole.
#include "solver/element/sand_survey.hpp"
#include "solver/reconsolidation/liquefied_conductivity.hpp"
#include "solver/ubcsand/ubcsand_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace quicksand {
namespace {

UbcSandParameters generic(double n1_60)
{
    return ubcsand_from_blow_count(n1_60);
}

/// Its plasticity is that of a rock, so that the elastic part shows.
UbcSandParameters elastic_at_small_strains()
{
    UbcSandParameters parameters = generic(12.0);
    parameters.plastic_shear_number = 1e12;
    parameters.reference_strain = 5e-4;
    parameters.least_modulus_fraction = 0.01;
    return parameters;
}

TEST(UbcSandCalibrated, PublishedLawHasNoFactorsAndNoHistory)
{
    const UbcSand law = make_ubcsand(generic(12.0));
    EXPECT_FALSE(keeps_history(law));
    EXPECT_EQ(law.elastic, ElasticForm::square_roots);
    UbcSandState state;
    state.sigma_x = state.sigma_z = 400e3, state.sigma_y = 800e3, state.tau_xy = 80e3;
    begin_shaking(law, state);
    EXPECT_EQ(state.start_factor, 1.0);
}

TEST(UbcSandCalibrated, StartFactorIsThatOfItsThreePowers)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    UbcSandState state;
    state.sigma_x = state.sigma_z = 400e3, state.sigma_y = 400e3, state.tau_xy = -40e3;
    begin_shaking(law, state);
    const double expected =
        std::pow(400.0 / 100.0, -0.18) * std::pow(2.0 / 1.5, 1.0) * (1.0 + 0.1 * (9.0 + 2.88));
    EXPECT_NEAR(state.start_factor, expected, 0.02 * expected); // one atmosphere is not 100 kPa quite
    EXPECT_NEAR(state.eta_max, 1.0 / 3.0, 1e-15);
}

/// Hardin and Drnevich (1972) with Masing's rule: G/Gmax = 1/(1 + g), and the area of the loop in closed
/// form.
TEST(UbcSandCalibrated, SmallStrainsFollowTheHyperbola)
{
    const SkeletonLaw law = make_ubcsand(elastic_at_small_strains());
    const Consolidation start{100e3, 1.0, 0.0};
    for (const double gamma : {1e-5, 1e-4, 5e-4}) {
        StrainCycles loading;
        loading.gamma = gamma, loading.cycles = 3.0;
        const CycleSummary second = summarize_cycles(shear_cyclically(law, start, loading).path).at(1);
        const double g = gamma / 5e-4, largest = shear_modulus(consolidate(law, start));
        EXPECT_NEAR(second.secant_modulus / largest, 1.0 / (1.0 + g), 2e-3);
        const double damping =
            4.0 / std::numbers::pi * (1.0 + 1.0 / g) * (1.0 - std::log(1.0 + g) / g) - 2.0 / std::numbers::pi;
        EXPECT_NEAR(second.damping_ratio, damping, 0.02 * damping + 2e-5);
    }
}

struct OnePoint {
    std::array<double, history_numbers> numbers{};
    ShakingHistory history{&numbers[0], &numbers[1], &numbers[2], &numbers[3], &numbers[4], &numbers[5]};
};

/// On the way from the floor to s_0 the compaction is the slope times the shear strain, at most 8 %, and the
/// line goes with the root of the stress.
TEST(UbcSandCalibrated, ReconsolidationIsThatOfYoshimineAndOthers)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    for (const double shear : {0.02, 0.2}) {
        OnePoint point;
        *point.history.start_mean = 75e3;
        *point.history.liquefied_shear = shear;
        const double whole = 1.5 * std::exp(-0.369 * std::sqrt(12.0)) * std::min(shear, 0.08);
        const double K_atm = law.B_atm + law.G_atm / 3.0, step = 1e-6;
        double s = 750.0, at_quarter = 0.0;
        const double begin = std::sqrt(s);
        while (s < 75e3) {
            const double compaction = compaction_of(law, step, s, 0, point.history);
            *point.history.compaction += compaction;
            s += (step - compaction) * K_atm * std::sqrt(s / atmospheric_pressure);
            if (s < 0.25 * 75e3) at_quarter = *point.history.compaction;
        }
        EXPECT_NEAR(*point.history.compaction, whole, 0.02 * whole);
        const double line = (std::sqrt(0.25 * 75e3) - begin) / (std::sqrt(75e3) - begin);
        EXPECT_NEAR(at_quarter, line * whole, 0.02 * whole);
    }
}

TEST(UbcSandCalibrated, SandThatHasNotLiquefiedOrSwellsDoesNotCompact)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    OnePoint point;
    *point.history.start_mean = 75e3;
    EXPECT_EQ(compaction_of(law, 1e-4, 50e3, 0, point.history), 0.0);
    *point.history.liquefied_shear = 0.05;
    EXPECT_EQ(compaction_of(law, -1e-4, 50e3, 0, point.history), 0.0);
    *point.history.compaction = 1.0; // more than there is
    EXPECT_EQ(compaction_of(law, 1e-4, 50e3, 0, point.history), 0.0);
}

/// Below the line it is elastic: a ripple there compacts nothing.
TEST(UbcSandCalibrated, RipplesBelowTheLineDoNotCompact)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    OnePoint point;
    *point.history.start_mean = 75e3;
    *point.history.liquefied_shear = 0.05;
    const double whole = law.reconsolidation * 0.05;
    *point.history.compaction = 0.8 * whole; // the line is at 0.64 s_0
    EXPECT_EQ(compaction_of(law, 1e-6, 30e3, 0, point.history), 0.0);
    EXPECT_GT(compaction_of(law, 1e-6, 50e3, 0, point.history), 0.9e-6);
}

/// The exponent of Shahir and others (2012) for falling pressure; sand that carries half its stress has the
/// pores of sand at rest.
TEST(UbcSandCalibrated, ConductivityRisesOnlyNearLiquefaction)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    const double most = law.liquefied_conductivity, floor = law.s_min, middle = 0.5 * (floor + 75e3);
    EXPECT_EQ(liquefied_conductivity_factor(most, 75e3, floor, 75e3), 1.0);
    EXPECT_DOUBLE_EQ(liquefied_conductivity_factor(most, floor, floor, 75e3), 5.0);
    EXPECT_NEAR(liquefied_conductivity_factor(most, middle, floor, 75e3), 1.0 + 4.0 * std::pow(0.5, 8.9),
                1e-12);
}

/// Else water from below would lift sand near the surface, which has hardly any stress to lose.
TEST(UbcSandCalibrated, SandAtTheFloorFloatsHoweverLittleStressItHad)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    const double most = law.liquefied_conductivity, floor = law.s_min;
    EXPECT_DOUBLE_EQ(liquefied_conductivity_factor(most, floor, floor, 2.0 * floor), 5.0);
    EXPECT_DOUBLE_EQ(liquefied_conductivity_factor(most, floor, floor, floor), 5.0);
}

/// Blocks of lanes give the bits of single points.
TEST(UbcSandCalibrated, LanesAreThePointsOneByOne)
{
    for (const Integration integration : {Integration::first_order, Integration::second_order}) {
        UbcSandParameters parameters = calibrated(generic(12.0));
        parameters.integration = integration;
        const UbcSand law = make_ubcsand(parameters);
        constexpr std::size_t count = 21;
        std::vector<UbcSandState> states(count);
        std::array<std::vector<double>, 30> columns;
        for (auto& column : columns) column.assign(count, 0.0);
        auto& c = columns;
        const UbcSandArrays arrays = {c[0].data(),  c[1].data(),  c[2].data(),  c[3].data(),  c[4].data(),
                                      c[5].data(),  c[6].data(),  c[7].data(),  c[8].data(),  c[9].data(),
                                      c[10].data(), c[11].data(), c[12].data(), c[13].data(), c[14].data(),
                                      c[15].data(), c[16].data(), c[17].data(), c[18].data(), c[19].data(),
                                      c[20].data(), c[21].data(), c[22].data(), c[23].data(), c[24].data(),
                                      c[25].data(), c[26].data(), c[27].data(), c[28].data(), c[29].data()};
        for (std::size_t p = 0; p < count; ++p) {
            states[p].sigma_y = 50e3 + 5e3 * static_cast<double>(p);
            states[p].sigma_x = states[p].sigma_z = 0.5 * states[p].sigma_y;
            states[p].tau_xy = 0.01 * static_cast<double>(p) * states[p].sigma_y;
            begin_shaking(law, states[p]);
            arrays.set(p, states[p]);
            c[25][p] = states[p].start_factor;
            c[29][p] = states[p].static_y;
        }
        for (int step = 0; step < 400; ++step) {
            const double shear = 4e-5 * std::cos(0.05 * step);
            for (std::size_t p = 0; p < count; ++p) {
                const double strain = shear * (1.0 + 0.1 * static_cast<double>(p));
                c[1][p] = -strain;
                update(law, {0.0, 0.0, strain, 0.0}, states[p]);
                UbcSandState turned = arrays.state(p); // a turn by nothing rounds
                turn(0.0, turned);
                arrays.set(p, turned);
            }
            update(law, 1.0, 0, count, arrays);
        }
        for (std::size_t p = 0; p < count; ++p) {
            EXPECT_EQ(states[p].sigma_y, arrays.state(p).sigma_y);
            EXPECT_EQ(states[p].tau_xy, arrays.state(p).tau_xy);
            EXPECT_EQ(states[p].sigma_z, arrays.state(p).sigma_z);
        }
    }
}

using Direction = std::array<double, 2>; // a unit vector of (eps_x - eps_y, gamma_xy)

/// Shear stress along a direction [Pa].
double shear_stress(const Direction& direction, const UbcSandState& state)
{
    return 0.5 * (state.sigma_x - state.sigma_y) * direction[0] + state.tau_xy * direction[1];
}

/// Undrained shear along a direction, or back, up to a shear stress [Pa].
void shear(const UbcSand& law, const Direction& direction, double amount, UbcSandState& state,
           double most = 1e9)
{
    const double sense = std::copysign(1.0, amount), step = 2e-5 * sense;
    const double x = 0.5 * step * direction[0], xy = step * direction[1];
    const auto steps = static_cast<int>(std::round(amount / step));
    for (int k = 0; k < steps && sense * shear_stress(direction, state) < most; ++k)
        update(law, {x, -x, xy, 0.0}, state);
}

/// Liquefied sand that has dilated in one sense is stiff in it, and flows in the other; however the sand has
/// turned since.
TEST(UbcSandCalibrated, SoftensAgainstTheSenseOfItsLastDilation)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    for (const double spin : {0.0, 0.7}) {
        UbcSandState state;
        state.sigma_x = state.sigma_z = 50e3, state.sigma_y = 100e3;
        begin_shaking(law, state);
        Direction sense{0.0, 1.0};
        for (int cycle = 0; cycle < 6; ++cycle)
            shear(law, sense, -0.5, state, 30e3), shear(law, sense, 0.5, state, 30e3);
        ASSERT_GE(shear_stress(sense, state), 30e3);
        turn(spin, state);
        const double angle = 4.0 * std::atan(0.5 * spin); // of vectors, twice that of the soil
        sense = {-std::sin(angle), std::cos(angle)};
        shear(law, sense, -0.03, state); // flows, and does not dilate
        EXPECT_LT(std::abs(shear_stress(sense, state)), 1e3);
        UbcSandState same = state, other = state;
        shear(law, sense, 0.015, same);
        shear(law, sense, -0.015, other);
        EXPECT_GT(shear_stress(sense, same), -20.0 * shear_stress(sense, other)) << spin;
        UbcSandState forgets = state;
        forgets.dilated_x = forgets.dilated_y = 0.0;
        shear(law, sense, 0.015, forgets);
        EXPECT_LT(shear_stress(sense, forgets), 0.05 * shear_stress(sense, same)) << spin;
    }
}

/// Locked sand flows in the sense of its static shear in proportion to it: on slopes it moves on downhill
/// from cycle to cycle.
TEST(UbcSandCalibrated, FlowsInTheSenseOfItsStaticShearThoughLocked)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    const auto strain_to_5_kPa = [&](double ratio, double spin) {
        UbcSandState state;
        state.sigma_x = state.sigma_z = 50e3, state.sigma_y = 100e3, state.tau_xy = ratio * 100e3;
        begin_shaking(law, state);
        Direction sense{0.0, 1.0};
        for (int cycle = 0; cycle < 6; ++cycle)
            shear(law, sense, -0.5, state, 30e3), shear(law, sense, 0.5, state, 30e3);
        turn(spin, state);
        const double angle = 4.0 * std::atan(0.5 * spin);
        sense = {-std::sin(angle), std::cos(angle)};
        shear(law, sense, -0.03, state); // locked in the other sense still
        double strain = 0.0;
        for (; shear_stress(sense, state) < 5e3 && strain < 0.1; strain += 2e-4)
            shear(law, sense, 2e-4, state);
        return strain;
    };
    const double level = strain_to_5_kPa(0.0, 0.0), gentle = strain_to_5_kPa(0.05, 0.0),
                 steep = strain_to_5_kPa(0.1, 0.0);
    EXPECT_GT(gentle, level + 2e-3);
    EXPECT_GT(steep, gentle + 2e-3);
    EXPECT_NEAR(strain_to_5_kPa(-0.1, 0.0), level, 2e-3); // against it
    EXPECT_NEAR(strain_to_5_kPa(0.1, 0.7), steep, 6e-4);
}

/// Loading at right angles to the static shear is neither along nor against it: a rounding error does not
/// decide.
TEST(UbcSandCalibrated, StaticShearCountsAlongTheLoadingAlone)
{
    const UbcSand law = make_ubcsand(calibrated(generic(12.0)));
    const auto strain_to_4_kPa = [&](double tau) {
        UbcSandState state;
        state.sigma_x = state.sigma_z = 50e3, state.sigma_y = 100e3, state.tau_xy = 10e3;
        begin_shaking(law, state);
        const Direction sense{-1.0, 0.0}; // vertical compression
        for (int cycle = 0; cycle < 6; ++cycle)
            shear(law, sense, -0.5, state, 30e3), shear(law, sense, 0.5, state, 30e3);
        shear(law, sense, -0.03, state);
        state.tau_xy = tau;
        double strain = 0.0;
        for (; shear_stress(sense, state) < 4e3 && strain < 0.15; strain += 1e-4)
            shear(law, sense, 1e-4, state);
        return strain;
    };
    EXPECT_NEAR(strain_to_4_kPa(1e-6), strain_to_4_kPa(-1e-6), 2e-4);
}

/// The table at (N1)60 = 12: Idriss and Boulanger (2008), Yoshimine and others (2006), Seed and
/// Idriss (1970), Darendeli (2001).
TEST(UbcSandCalibrated, MeetsWhatLaboratoriesKnow)
{
    const SandSurvey s = survey(make_ubcsand(calibrated(generic(12.0))));
    ASSERT_TRUE(s.strength && s.k_sigma && s.k_0 && s.k_alpha);
    EXPECT_NEAR(s.strength->csr_15, 0.1325, 0.08 * 0.1325); // triggering curve
    EXPECT_NEAR(*s.k_sigma, 0.79, 0.07);
    EXPECT_NEAR(*s.k_0, 1.3, 0.2 + 0.15);
    EXPECT_NEAR(*s.k_alpha, 1.1, 0.2 + 0.15);
    ASSERT_EQ(s.strain_of_cycles.size(), 6U);
    for (std::size_t k = 1; k < 6; ++k) EXPECT_GT(s.strain_of_cycles[k], 1.005 * s.strain_of_cycles[k - 1]);
    EXPECT_GT(s.strain_of_cycles[5], 0.03);
    EXPECT_LE(s.most_out_of_plane, 1.0001);
    EXPECT_GT(s.reconsolidation, 0.0334 / 1.5);
    EXPECT_LT(s.reconsolidation, 0.0334 * 1.5);
    EXPECT_NEAR(s.curve[1].modulus_ratio, 0.81, 0.11);
    EXPECT_NEAR(s.curve[2].modulus_ratio, 0.61, 0.13);
    EXPECT_NEAR(s.curve[0].damping_ratio, 0.010, 0.006);
}

} // namespace
} // namespace quicksand
