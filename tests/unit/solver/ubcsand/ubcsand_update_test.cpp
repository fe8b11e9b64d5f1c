#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_flow.hpp"
#include "solver/ubcsand/ubcsand_particles.hpp"
#include "tests/fixtures/sand_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using fixtures::mean_in_plane;

double stress_ratio(const UbcSand& law, const UbcSandState& state)
{
    return std::hypot(0.5 * (state.sigma_x - state.sigma_y), state.tau_xy) / (mean_in_plane(state) + law.a);
}

/// Reversals of less than 1e-4 are ripples.
UbcSand sand_with_ripples()
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.ripple_strain = 1e-4;
    return make_ubcsand(parameters);
}

UbcSandState consolidated(const UbcSand& law, double k0)
{
    UbcSandState state;
    state.sigma_x = state.sigma_z = k0 * 100e3;
    state.sigma_y = 100e3;
    begin_shaking(law, state);
    return state;
}

UbcSandIncrement shear(double gamma)
{
    return {0.0, 0.0, gamma, 0.0};
}

TEST(UbcSand, BeginsShakingOnTheLocusOfItsPresentStress)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    const UbcSandState state = consolidated(law, 0.5);
    EXPECT_NEAR(state.eta_max, 1.0 / 3.0, 1e-15); // 25/75
    EXPECT_NEAR(state.peak_x, -1.0 / 3.0, 1e-15);
    EXPECT_EQ(state.peak_y, 0.0);
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 0.0);
}

TEST(UbcSand, ElasticModuliAreThoseOfTheGenericSetAtOneAtmosphere)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(15.0));
    const UbcSandState state = consolidated(law, 1.0);
    EXPECT_NEAR(shear_modulus(law, state), 107.03e6, 0.01e6);       // 1070.3 P_a
    EXPECT_NEAR(constrained_modulus(law, state), 217.63e6, 0.02e6); // (749.2 + 4/3 1070.3) P_a
    EXPECT_NEAR(shear_modulus(law, consolidated(law, 0.5)), 107.03e6 * std::sqrt(0.75), 0.01e6);
}

TEST(UbcSand, ThePlasticModulusIsTheHyperbolaTimesTheFactor)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(15.0));
    const double number = ubcsand::plastic_number(law, 50e3);
    // 2 x 822.4 x 100 kPa x 0.5^0.4 x (1 - 0.7328 x 0.3/sin 34.5 deg)^2
    EXPECT_NEAR(2.0 * ubcsand::plastic_modulus(law, number, 0.3), 46.65e6, 0.05e6);
}

TEST(UbcSand, TheFactorStiffensReloadingAndSoftensAfterDilation)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState state;
    state.half_cycles = 6.0;
    state.origin_x = state.peak_x = 0.3;
    ubcsand::Deviator q = {-1.0, 0.0};
    const auto factors = [&] { return ubcsand::hardening_factors<ubcsand::Locking::none>(law, q, state); };
    EXPECT_DOUBLE_EQ(factors().virgin, 1.0);
    EXPECT_DOUBLE_EQ(factors().secondary, 0.6 * (4.0 + 0.5 * 6.0));
    state.active_dilation = 1e-3;
    EXPECT_NEAR(factors().virgin, std::exp(-1.0), 1e-14);
    EXPECT_NEAR(factors().secondary, 4.2 * std::exp(-1.0), 1e-14);
    state.active_dilation = 0.1;
    EXPECT_DOUBLE_EQ(factors().secondary, 0.05);
    q.x = 1.0; // the branch has not crossed the isotropic axis
    EXPECT_DOUBLE_EQ(factors().secondary, 4.2);
}

TEST(UbcSand, TheLeastFactorFallsWithTheDilationOfTheLastHalfCycle)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.dilation_strain = 0.02;
    const UbcSand law = make_ubcsand(parameters);
    UbcSandState state;
    state.origin_x = state.peak_x = 0.3;
    for (const double dilation : {0.02, 0.06}) {
        state.active_dilation = dilation;
        EXPECT_NEAR(ubcsand::hardening_factors<ubcsand::Locking::none>(law, {-1.0, 0.0}, state).secondary,
                    0.05 / (1.0 + dilation / 0.02), 1e-15);
    }
}

TEST(UbcSand, TheFactorOfDilationLeavesContractionAlone)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.dilation_factor = 3.0;
    const UbcSand law = make_ubcsand(parameters);
    ubcsand::Trial trial{};
    trial.least_D = -1.0, trial.most_D = 1.0;
    EXPECT_NEAR(ubcsand::contraction(law, trial, law.sin_cv - 0.1), 0.1, 1e-15);
    EXPECT_NEAR(ubcsand::contraction(law, trial, law.sin_cv + 0.1), -0.3, 1e-15);
}

// K_sigma falls with depth, and is not above its limit near the surface.
TEST(UbcSand, TheStartWeakensUnderMoreThanOneAtmosphereAlone)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.confining_exponent = 0.2;
    const UbcSand law = make_ubcsand(parameters);
    const auto factor_under = [&](double vertical) {
        UbcSandState state;
        state.sigma_x = state.sigma_z = 0.5 * vertical;
        state.sigma_y = vertical;
        begin_shaking(law, state);
        return state.start_factor;
    };
    EXPECT_EQ(factor_under(0.1 * atmospheric_pressure), 1.0);
    EXPECT_NEAR(factor_under(4.0 * atmospheric_pressure), std::pow(4.0, -0.2), 1e-12);
}

TEST(UbcSand, UnloadingIsElasticAndKeepsTheMeanStress)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState state = consolidated(law, 1.0);
    update(law, shear(5e-4), state);
    const UbcSandState peak = state;
    ASSERT_LT(mean_in_plane(peak), 99e3); // loading contracts
    update(law, shear(-1e-6), state);
    EXPECT_NEAR(mean_in_plane(state), mean_in_plane(peak), 1e-9);
    EXPECT_NEAR(state.tau_xy, peak.tau_xy - 1e-6 * shear_modulus(law, peak), 1e-9);
    EXPECT_EQ(state.branch, ubcsand::strain_reversed);
    EXPECT_NEAR(state.peak_y, peak.tau_xy / mean_in_plane(peak), 1e-15);
}

TEST(UbcSand, OnlyARealReversalCountsAHalfCycle)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState state = consolidated(law, 1.0);
    update(law, shear(5e-4), state);
    const UbcSandState peak = state;
    // an excursion of 0.01 in ratio is reloaded elastically ...
    const double tiny = 0.01 * mean_in_plane(peak) / shear_modulus(law, peak);
    update(law, shear(-tiny), state);
    update(law, shear(0.99 * tiny), state);
    EXPECT_EQ(state.half_cycles, 0.0);
    EXPECT_EQ(state.branch, ubcsand::strain_reversed);
    update(law, shear(0.1 * tiny), state);
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 0.0);
    // ... one of 0.05 drags the locus back and counts
    state = peak;
    update(law, shear(-5.0 * tiny), state);
    EXPECT_EQ(state.branch, ubcsand::far_from_reversal);
    update(law, shear(tiny), state);
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 1.0);
    EXPECT_LT(mean_in_plane(state), mean_in_plane(peak));
    update(law, shear(20.0 * tiny), state);
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 1.0);
}

TEST(UbcSand, ARippleIsNoHalfCycleAndAReversalIsOneAtOnceAfterIt)
{
    const UbcSand law = sand_with_ripples();
    UbcSandState state = consolidated(law, 1.0);
    update(law, shear(5e-4), state);
    update(law, shear(-5e-5), state); // far in ratio, but the strain has not turned: a ripple of the loading
    EXPECT_EQ(state.branch, ubcsand::just_reversed);
    update(law, shear(6e-5), state);
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 0.0);
    EXPECT_EQ(state.waiting, ubcsand::even);
    for (int k = 0; k < 40; ++k) update(law, shear(-1e-5), state); // 4e-4 back, loads on the other side
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 1.0);
    for (int k = 0; k < 10; ++k) { // ripples of the way back
        update(law, shear(4e-5), state);
        update(law, shear(-5e-5), state);
        EXPECT_LE(state.half_cycles, 2.0);
    }
    EXPECT_GT(state.origin_y, 0.0); // where the loading ended, not the ripples
}

TEST(UbcSand, ARippleOfUnloadingReloadsWithoutLoading)
{
    const UbcSand law = sand_with_ripples();
    UbcSandState state = consolidated(law, 1.0);
    update(law, shear(5e-4), state);
    const UbcSandState peak = state;
    for (int k = 0; k < 12; ++k) update(law, shear(-1e-5), state);
    EXPECT_EQ(state.branch, ubcsand::far_from_reversal);
    update(law, shear(2e-5), state);
    EXPECT_EQ(state.branch, ubcsand::loading_in_ripple);
    EXPECT_EQ(state.half_cycles, 0.0);
    update(law, shear(-3e-5), state); // on with the unloading, from the same peak
    EXPECT_EQ(state.branch, ubcsand::far_from_reversal);
    EXPECT_NEAR(state.peak_y, peak.tau_xy / mean_in_plane(peak), 1e-12);
    for (int k = 0; k < 12; ++k) update(law, shear(1e-5), state); // a true reversal
    EXPECT_EQ(state.branch, ubcsand::loading);
    EXPECT_EQ(state.half_cycles, 1.0);
}

TEST(UbcSand, RipplesAreMeasuredByTheLegWhenThatIsShort)
{
    // small stresses have small strains: legs of 4e-5 are half cycles although a ripple may have 1e-4
    const UbcSand law = sand_with_ripples();
    UbcSandState state;
    state.sigma_x = state.sigma_y = state.sigma_z = 2e3;
    begin_shaking(law, state);
    for (int k = 0; k < 10; ++k) update(law, shear(2e-6), state);
    for (int half = 0; half < 6; ++half) {
        for (int k = 0; k < 20; ++k) update(law, shear(half % 2 == 0 ? -2e-6 : 2e-6), state);
    }
    EXPECT_EQ(state.half_cycles, 6.0);
}

TEST(UbcSand, FailureCarriesTheCohesionOfMohrAndCoulomb)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.cohesion = 10e3;
    const UbcSand law = make_ubcsand(parameters);
    UbcSandState state = consolidated(law, 0.5);
    for (int k = 0; k < 2000; ++k) update(law, {-2e-5, 2e-5, 0.0, 0.0}, state);
    const double phi = parameters.peak_friction_deg * std::numbers::pi / 180.0;
    const double radius = 0.5 * (state.sigma_y - state.sigma_x);
    EXPECT_NEAR(radius, mean_in_plane(state) * std::sin(phi) + 10e3 * std::cos(phi), 1e-6 * radius);
}

TEST(UbcSand, DilationLiftsAPointOffTheStressFloor)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState state = consolidated(law, 1.0);
    update(law, {-1e-2, -1e-2, 0.0, 0.0}, state); // pulled apart
    ASSERT_EQ(mean_in_plane(state), law.s_min);
    for (int k = 0; k < 500; ++k) update(law, shear(1e-4), state);
    EXPECT_GT(mean_in_plane(state), 10.0 * law.s_min);
    EXPECT_NEAR(stress_ratio(law, state), law.eta_f, 1e-12);
}

TEST(UbcSand, ASpinTurnsStressAndMemoryByTwiceItsAngle)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState state = consolidated(law, 0.5);
    const UbcSandState before = state;
    // tan(angle/2) = spin/2: an angle of 45 deg turns x into the diagonal
    const double spin = 2.0 * std::tan(std::numbers::pi / 8.0);
    turn(spin, state);
    EXPECT_NEAR(state.sigma_x, 75e3, 1e-9);
    EXPECT_NEAR(state.sigma_y, 75e3, 1e-9);
    EXPECT_NEAR(state.tau_xy, -25e3, 1e-9);
    EXPECT_NEAR(state.peak_x, 0.0, 1e-15);
    EXPECT_NEAR(state.peak_y, -1.0 / 3.0, 1e-15);
    turn(-spin, state);
    EXPECT_NEAR(state.sigma_x, before.sigma_x, 1e-9);
    EXPECT_NEAR(state.peak_x, before.peak_x, 1e-15);
}

TEST(UbcSand, AnAbsurdStrainEndsInBoundedTimeInsideTheLimit)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    for (const UbcSandIncrement& huge :
         {shear(100.0), UbcSandIncrement{-50.0, 50.0, 0.0, 0.0}, UbcSandIncrement{10.0, 10.0, 1.0, 3.0},
          UbcSandIncrement{-10.0, -10.0, 1.0, -3.0}}) {
        UbcSandState state = consolidated(law, 0.5);
        update(law, huge, state);
        EXPECT_TRUE(std::isfinite(state.sigma_x + state.sigma_y + state.sigma_z + state.tau_xy));
        EXPECT_LE(stress_ratio(law, state), law.eta_f * (1.0 + 1e-9));
    }
}

TEST(UbcSand, TheLoosestSandShearsAtConstantVolume)
{
    for (const Integration integration : {Integration::first_order, Integration::second_order}) {
        UbcSandParameters parameters = nevada_sand_55();
        parameters.integration = integration;
        const UbcSand law = make_ubcsand(parameters);
        UbcSandState free = consolidated(law, 0.6), loosest = free;
        loosest.least_contraction = 0.0;
        for (int k = 0; k < 4000; ++k) { // 4 % of shear at constant volume
            update(law, shear(1e-5), free);
            update(law, shear(1e-5), loosest);
        }
        EXPECT_GT(mean_in_plane(free), 1.05 * mean_in_plane(loosest)); // dilation presses the free sand
        const double before = mean_in_plane(loosest);
        for (int k = 0; k < 1000; ++k) update(law, shear(1e-5), loosest);
        EXPECT_NEAR(mean_in_plane(loosest), before, 1e-6 * before);
        EXPECT_NEAR(loosest.tau_xy, failure_shear(law, before), 0.02 * before);
    }
}

TEST(UbcSand, TheDensestSandDoesNotContract)
{
    for (const Integration integration : {Integration::first_order, Integration::second_order}) {
        UbcSandParameters parameters = nevada_sand_55();
        parameters.integration = integration;
        const UbcSand law = make_ubcsand(parameters);
        UbcSandState free = consolidated(law, 1.0), densest = free;
        densest.most_contraction = 0.0;
        const double start = mean_in_plane(densest);
        for (int k = 0; k < 4000; ++k) { // cycles of 0.1 % at constant volume
            const double sense = k / 100 % 4 == 0 || k / 100 % 4 == 3 ? 1.0 : -1.0;
            update(law, shear(sense * 1e-5), free);
            update(law, shear(sense * 1e-5), densest);
            ASSERT_GE(mean_in_plane(densest), start * (1.0 - 1e-12));
        }
        EXPECT_LT(mean_in_plane(free), 0.5 * start); // contraction takes the stress off the free sand
    }
}

TEST(UbcSand, GrainsThatHavePartedBearNothingUntilTheyTouch)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState state = consolidated(law, 1.0);
    state.least_contraction = 0.0; // looser than the loosest
    update(law, {-0.05, -0.05, 0.0, 0.0}, state);
    EXPECT_NEAR(mean_in_plane(state), law.s_min, 1e-6);
    update(law, {0.02, 0.02, 0.01, 0.0}, state); // on the way back
    EXPECT_NEAR(mean_in_plane(state), law.s_min, 1e-6);
    state.least_contraction = -1.0; // they touch
    update(law, {1e-4, 1e-4, 0.0, 0.0}, state);
    EXPECT_GT(mean_in_plane(state), 2.0 * law.s_min);
}

} // namespace
} // namespace quicksand
