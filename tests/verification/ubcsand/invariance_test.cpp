// What must not change the answer: the frame, the size of the substeps, the size of the steps.
#include "solver/element/cyclic_laboratory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace quicksand {
namespace {

/// The state and the strain seen in axes turned by an angle.
UbcSandState turned(const UbcSandState& state, double angle)
{
    UbcSandState result = state;
    turn(2.0 * std::tan(0.5 * angle), result);
    return result;
}

UbcSandIncrement turned(const UbcSandIncrement& strain, double angle)
{
    const double c = std::cos(2.0 * angle), s = std::sin(2.0 * angle);
    const double mean = 0.5 * (strain.strain_x + strain.strain_y);
    const double difference = 0.5 * (strain.strain_x - strain.strain_y), half_shear = 0.5 * strain.shear;
    const double deviator = c * difference - s * half_shear;
    return {mean + deviator, mean - deviator, 2.0 * (s * difference + c * half_shear), strain.spin};
}

double distance(const UbcSandState& a, const UbcSandState& b)
{
    return std::abs(a.sigma_x - b.sigma_x) + std::abs(a.sigma_y - b.sigma_y) +
           std::abs(a.sigma_z - b.sigma_z) + std::abs(a.tau_xy - b.tau_xy);
}

/// At 100 kPa and K0 = 0.5.
UbcSandState consolidated(const UbcSand& law)
{
    UbcSandState state;
    state.sigma_x = state.sigma_z = 50e3, state.sigma_y = 100e3;
    begin_shaking(law, state);
    return state;
}

TEST(UbcSandFrame, AnyAxesGiveTheSameStress)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState fixed = consolidated(law);
    UbcSandState rotated = turned(fixed, 0.7);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    double worst = 0.0;
    for (int step = 0; step < 3000; ++step) {
        const double drift = 4e-5 * std::sin(0.02 * step);
        const UbcSandIncrement strain = {1e-5 * normal(random), 1e-5 * normal(random),
                                         drift + 2e-5 * normal(random), 0.0};
        update(law, strain, fixed);
        update(law, turned(strain, 0.7), rotated);
        worst = std::max(worst, distance(turned(fixed, 0.7), rotated));
    }
    EXPECT_GT(fixed.half_cycles, 100.0); // the path is not a simple one
    EXPECT_LT(worst, 1e-10 * 100e3);
}

TEST(UbcSandFrame, ABodyThatTurnsWhileItStrainsKeepsItsStressInItsOwnAxes)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    UbcSandState fixed = consolidated(law), turning = fixed;
    const double per_step = 0.01; // the angle
    double angle = 0.0, worst = 0.0;
    for (int step = 0; step < 2000; ++step) {
        const UbcSandIncrement strain = {1e-6 * std::cos(0.3 * step), -1e-6 * std::cos(0.3 * step),
                                         3e-5 * std::cos(0.02 * step), 0.0};
        angle += per_step;
        UbcSandIncrement seen = turned(strain, angle);
        seen.spin = 2.0 * std::tan(0.5 * per_step);
        update(law, strain, fixed);
        update(law, seen, turning);
        // turned back in the same small steps' sum
        UbcSandState back = turning;
        turn(2.0 * std::tan(-0.5 * std::remainder(angle, 6.283185307179586)), back);
        worst = std::max(worst, distance(fixed, back));
    }
    EXPECT_LT(worst, 1e-10 * 100e3);
}

double ru_after(const UbcSandParameters& parameters, double cycles)
{
    const CyclicTest test = shear_cyclically(make_ubcsand(parameters), {}, StressCycles{0.15, cycles, 0.1});
    double ru = 0.0;
    for (const ElementPoint& point : test.path) {
        if (point.cycle <= cycles) ru = point.ru;
    }
    return ru;
}

TEST(UbcSandSubsteps, AreFineEnough)
{
    for (const double n1_60 : {10.0, 13.9, 20.0}) {
        UbcSandParameters parameters = ubcsand_from_blow_count(n1_60);
        const double usual = ru_after(parameters, 5.0);
        parameters.largest_ratio_step /= 8.0;
        parameters.largest_stress_step /= 8.0;
        EXPECT_NEAR(usual, ru_after(parameters, 5.0), 0.002) << "(N1)60 = " << n1_60;
    }
}

/// Largest difference of tau and sigma'_v of two laws on the same cycles of strain, over sigma'_v0 [-].
double difference(const UbcSandParameters& a, const UbcSandParameters& b, double gamma, double step)
{
    Specimen one = consolidate(make_ubcsand(a), {}), other = consolidate(make_ubcsand(b), {});
    const int steps_of_a_leg = static_cast<int>(std::lround(gamma / step));
    double worst = 0.0;
    for (int k = 0; k < 15 * steps_of_a_leg; ++k) {
        const double sense = (k / steps_of_a_leg + 1) / 2 % 2 == 0 ? step : -step;
        strain(0.0, 0.0, sense, one);
        strain(0.0, 0.0, sense, other);
        worst = std::max({worst, std::abs(one.tau() - other.tau()) / 100e3,
                          std::abs(one.sigma_y() - other.sigma_y()) / 100e3});
    }
    return worst;
}

TEST(UbcSandSubsteps, OfARunAreFineEnoughBeforeAndAfterLiquefaction)
{
    for (const double n1_60 : {5.0, 13.9, 20.0}) {
        UbcSandParameters fine = ubcsand_from_blow_count(n1_60);
        UbcSandRunSettings settings;
        settings.ripple_strain = 0.0;
        const UbcSandParameters coarse = with(settings, fine);
        fine.largest_ratio_step /= 4.0;
        fine.largest_stress_step /= 4.0;
        EXPECT_LT(difference(coarse, fine, 2e-2, 2.5e-4), 0.01) << n1_60; // strong shaking
        for (const double gamma : {5e-4, 2e-3, 2e-2}) {
            // the steps of strain of a semi-implicit run
            EXPECT_LT(difference(coarse, fine, gamma, 3e-5), 0.005) << n1_60 << " " << gamma;
        }
        EXPECT_LT(difference(coarse, fine, 5e-4, 3e-6), 0.001) << n1_60; // of an explicit one
    }
}

/// Stress after loading at constant volume to a shear strain in a number of substeps.
UbcSandState sheared(double k0, double gamma, int substeps, Integration integration)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.integration = integration;
    parameters.largest_ratio_step = parameters.largest_stress_step = 1e9; // a substep of each step
    parameters.substep_tolerance = 1e9;
    Specimen specimen = consolidate(make_ubcsand(parameters), {100e3, k0, 0.0});
    for (int k = 0; k < substeps; ++k) strain(0.0, 0.0, gamma / substeps, specimen);
    UbcSandState state;
    state.sigma_x = specimen.sigma_x(), state.sigma_y = specimen.sigma_y(),
    state.sigma_z = specimen.sigma_z();
    state.tau_xy = specimen.tau();
    return state;
}

double integration_order(Integration integration, double k0, double gamma)
{
    const UbcSandState exact = sheared(k0, gamma, 32768, Integration::second_order);
    const double coarse = distance(sheared(k0, gamma, 64, integration), exact);
    return std::log2(coarse / distance(sheared(k0, gamma, 128, integration), exact));
}

TEST(UbcSandSubsteps, AreOfTheirOrder)
{
    for (const double gamma : {3e-4, 1e-3}) { // at K0 = 0.5 the principal stresses turn
        for (const double k0 : {0.5, 1.0}) {
            EXPECT_NEAR(integration_order(Integration::first_order, k0, gamma), 1.0, 0.1)
                << k0 << " " << gamma;
            EXPECT_NEAR(integration_order(Integration::second_order, k0, gamma), 2.0, 0.2)
                << k0 << " " << gamma;
        }
    }
}

TEST(UbcSandSubsteps, MakeLongStepsAsGoodAsShortOnes)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    const double few = shear_cyclically(law, {}, StrainCycles{3e-4, 5.0, 20.0}).path.back().ru;
    const double many = shear_cyclically(law, {}, StrainCycles{3e-4, 5.0, 2000.0}).path.back().ru;
    EXPECT_NEAR(few, many, 0.005);
}

} // namespace
} // namespace quicksand
