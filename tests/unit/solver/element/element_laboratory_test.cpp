#include "solver/base/failure.hpp"
#include "solver/element/cyclic_laboratory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

UbcSand nevada()
{
    return make_ubcsand(nevada_sand_55());
}

TEST(ElementTest, ConsolidationHasItsStresses)
{
    const Specimen specimen = consolidate(nevada(), {200e3, 0.6, 15e3});
    EXPECT_EQ(specimen.sigma_y(), 200e3);
    EXPECT_EQ(specimen.sigma_x(), 120e3);
    EXPECT_EQ(specimen.sigma_z(), 120e3);
    EXPECT_EQ(specimen.tau(), 15e3);
    EXPECT_EQ(record(specimen, 0.0).ru, 0.0);
}

TEST(ElementTest, ASpecimenThatFailsInConsolidationIsRefused)
{
    EXPECT_THROW(consolidate(nevada(), {100e3, 0.016}), InputError); // elastic gravity loading
    EXPECT_THROW(consolidate(nevada(), {100e3, 0.5, 60e3}), InputError);
    EXPECT_THROW(consolidate(nevada(), {-1.0}), InputError);
    EXPECT_THROW(shear_cyclically(nevada(), {}, StressCycles{0.0}), InputError);
    EXPECT_THROW(compress_in_oedometer(nevada(), {}, {-5e3}), InputError);
}

TEST(ElementTest, ANumberThatMustBePositiveIsNamed)
{
    const auto complaint = [](auto&& test) {
        try {
            test();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const UbcSand law = nevada();
    EXPECT_EQ(complaint([&] { consolidate(law, {-1.0}); }),
              "element test: vertical_stress and k0 must be positive");
    EXPECT_EQ(complaint([&] { shear_cyclically(law, {}, StressCycles{0.0}); }),
              "element test: csr must be positive");
    EXPECT_EQ(complaint([&] { shear_cyclically(law, {}, StrainCycles{0.0}); }),
              "element test: gamma must be positive");
    EXPECT_EQ(complaint([&] { compress_in_oedometer(law, {}, {-5e3}); }),
              "element test: a stress to compress to must be positive");
}

TEST(ElementTest, IsotropicCompressionIsTheIntegralOfTheModulus)
{
    // ds = K' d eps_v with K' = K'_atm (s/P_a)^1/2: eps_v = 2 P_a/K'_atm [(s/P_a)^1/2 - (s_0/P_a)^1/2]
    const UbcSand law = nevada();
    const ElementPath path = compress_isotropically(law, {100e3, 1.0}, {400e3, 100e3});
    const auto loaded = std::max_element(path.begin(), path.end(),
                                         [](const auto& a, const auto& b) { return a.sigma_x < b.sigma_x; });
    const double exact = 2.0 * 100e3 / (law.B_atm + law.G_atm / 3.0) * (2.0 - 1.0);
    EXPECT_NEAR(loaded->sigma_x, 400e3, 1.0);
    EXPECT_NEAR(loaded->volumetric_strain(), exact, 0.005 * exact);
    EXPECT_NEAR(path.back().volumetric_strain(), 0.0, 0.01 * exact); // reversible
    EXPECT_EQ(path.back().tau, 0.0);
}

TEST(ElementTest, TheOedometerKeepsItsWidthAndMeetsItsStresses)
{
    const ElementPath path = compress_in_oedometer(nevada(), {}, {400e3, 200e3});
    double largest = 0.0;
    for (const ElementPoint& point : path) {
        EXPECT_EQ(point.strain_x, 0.0);
        EXPECT_EQ(point.ru, 0.0);
        largest = std::max(largest, point.sigma_y);
    }
    EXPECT_NEAR(largest, 400e3, 1.0);
    EXPECT_NEAR(path.back().sigma_y, 200e3, 1.0);
    // unloading is stiffer than loading, and locks lateral stress in
    EXPECT_GT(path.back().strain_y, 0.0);
    EXPECT_GT(path.back().sigma_x / path.back().sigma_y, 0.5);
}

TEST(ElementTest, DrainedBiaxialCompressionFailsAtThePeakFriction)
{
    const UbcSand law = nevada();
    const ElementPath path = compress_biaxially(law, {100e3, 1.0}, Drainage::drained, 0.05);
    const double passive = (1.0 + law.eta_f) / (1.0 - law.eta_f);
    EXPECT_NEAR(path.back().sigma_y, 100e3 * passive, 100.0);
    for (const ElementPoint& point : path) EXPECT_NEAR(point.sigma_x, 100e3, 1.0);
    // on the failure line: d eps_v = sin phi_cv - sin phi_f per shear strain eps_y - eps_x
    const ElementPoint &last = path.back(), &before = path[path.size() - 100];
    const double volume = last.volumetric_strain() - before.volumetric_strain();
    const double shear = last.strain_y - last.strain_x - before.strain_y + before.strain_x;
    EXPECT_NEAR(volume / shear, law.sin_cv - law.eta_f, 1e-6);
}

TEST(ElementTest, UndrainedBiaxialCompressionKeepsItsVolume)
{
    const ElementPath path = compress_biaxially(nevada(), {100e3, 1.0}, Drainage::undrained, 0.02);
    double largest_ru = 0.0;
    for (const ElementPoint& point : path) {
        EXPECT_NEAR(point.volumetric_strain(), 0.0, 1e-15);
        EXPECT_NEAR(point.ru, 1.0 - point.sigma_x / 100e3, 1e-12);
        largest_ru = std::max(largest_ru, point.ru);
    }
    EXPECT_GT(largest_ru, 0.3);                   // contraction first
    EXPECT_LT(path.back().ru, largest_ru - 0.05); // then dilation
}

TEST(ElementTest, StressCyclesTurnAtTheirAmplitude)
{
    const CyclicTest test = shear_cyclically(nevada(), {100e3, 0.5, 5e3}, StressCycles{0.1, 3.0});
    double most = -1e9, least = 1e9;
    for (std::size_t k = 1; k < test.path.size(); ++k) {
        most = std::max(most, test.path[k].tau);
        least = std::min(least, test.path[k].tau);
        EXPECT_GE(test.path[k].cycle, test.path[k - 1].cycle - 1e-12);
        EXPECT_LE(std::abs(test.path[k].tau - test.path[k - 1].tau), 0.0241 * 10e3);
    }
    EXPECT_NEAR(most, 15e3, 1.0);
    EXPECT_NEAR(least, -5e3, 1.0);
    EXPECT_NEAR(test.path.back().cycle, 3.25, 1e-3);
}

TEST(ElementTest, StrainCyclesTurnAtTheirAmplitudeAndEndAtZero)
{
    const CyclicTest test = shear_cyclically(nevada(), {}, StrainCycles{5e-4, 10.0});
    double most = 0.0, least = 0.0;
    for (const ElementPoint& point : test.path) {
        most = std::max(most, point.gamma);
        least = std::min(least, point.gamma);
    }
    EXPECT_NEAR(most, 5e-4, 1e-15);
    EXPECT_NEAR(least, -5e-4, 1e-15);
    EXPECT_NEAR(test.path.back().gamma, 0.0, 1e-15);
    EXPECT_NEAR(test.path.back().cycle, 10.0, 1e-9);
    EXPECT_NEAR(test.path.back().ru, 0.98, 0.01);
}

TEST(ElementTest, StrainCriteriaComeInTheirOrder)
{
    const CyclicTest test =
        shear_cyclically(make_ubcsand(ubcsand_from_blow_count(5.0)), {}, StressCycles{0.1, 20.0});
    ASSERT_TRUE(test.cycles_to_ru_95 && test.cycles_to_3_percent && test.cycles_to_375_percent);
    EXPECT_NEAR(*test.cycles_to_ru_95, *test.cycles_to_3_percent, 1.0);
    EXPECT_LE(*test.cycles_to_3_percent, *test.cycles_to_375_percent);
}

/// Strain under static shear grows to one side: its range from reversal to reversal comes later than its
/// size.
TEST(ElementTest, TheDoubleAmplitudeIsTheStrainBetweenReversals)
{
    const UbcSand sand = make_ubcsand(calibrated(ubcsand_from_blow_count(6.0)));
    for (const double shear : {0.0, 10e3}) {
        const CyclicTest test = shear_cyclically(sand, {100e3, 0.5, shear}, StressCycles{0.12, 20.0, 0.5});
        ASSERT_TRUE(test.cycles_to_75_double && test.cycles_to_375_percent);
        EXPECT_GE(*test.cycles_to_75_double, *test.cycles_to_375_percent);
        double turned = 0.0, last = 0.0;
        int legs = 0;
        for (const ElementPoint& point : test.path) {
            const int leg = static_cast<int>(std::floor(2.0 * point.cycle + 0.5 - 1e-9));
            if (leg > legs) turned = last;
            legs = leg;
            last = point.gamma;
            if (leg == 0) continue;
            const double range = std::abs(point.gamma - turned);
            if (0.5 * leg < *test.cycles_to_75_double) {
                EXPECT_LT(range, 0.0751);
            }
        }
    }
}

TEST(ElementTest, AWeakSpecimenFlowsToTheStrainLimitInTheFirstQuarter)
{
    const CyclicTest test = shear_cyclically(make_ubcsand(ubcsand_from_blow_count(3.0)), {100e3, 1.0},
                                             StressCycles{0.3, 5.0, 0.05});
    EXPECT_GT(test.path.back().gamma, 0.05);
    EXPECT_EQ(test.cycles_to_3_percent.value_or(-1.0), 0.0);
}

TEST(ElementTest, StrengthIsInterpolatedInLogarithms)
{
    const std::vector<StrengthPoint> points = {{0.1, 100.0}, {0.2, 10.0}, {0.4, 1.0}};
    EXPECT_NEAR(interpolate_csr(points, 10.0).value_or(0.0), 0.2, 1e-15);
    EXPECT_NEAR(interpolate_csr(points, std::sqrt(1000.0)).value_or(0.0), std::sqrt(0.02), 1e-15);
    EXPECT_FALSE(interpolate_csr(points, 200.0));
    EXPECT_FALSE(interpolate_csr(points, 0.5));
}

TEST(ElementTest, TheStrengthAtACountOfCyclesReachesIt)
{
    const UbcSand law = nevada();
    const double csr = csr_to_ru_95(law, {}, 7.0).value();
    const CyclicTest test = shear_cyclically(law, {}, StressCycles{csr, 20.0, 0.5, 0.0});
    EXPECT_EQ(test.cycles_to_ru_95.value_or(0.0), 7.0);
}

TEST(ElementTest, NoStrengthIsToldBeyondTheSearch)
{
    EXPECT_TRUE(csr_to_ru_95(nevada(), {}, 15.0));
    UbcSandParameters parameters = nevada_sand_55();
    parameters.plastic_shear_number = 1e4; // next to no plastic strain
    const UbcSand law = make_ubcsand(parameters);
    EXPECT_FALSE(csr_to_ru_95(law, {}, 15.0));
    EXPECT_FALSE(cyclic_strength(law, {}));
}

TEST(ElementTest, StressesInThreeDimensionsHaveTheirInvariants)
{
    ElementPoint point;
    point.sigma_x = 50e3, point.sigma_y = 100e3, point.sigma_z = 60e3, point.tau = 20e3;
    EXPECT_DOUBLE_EQ(point.mean_stress(), 70e3);
    // q^2 = [(x - y)^2 + (y - z)^2 + (z - x)^2]/2 + 3 tau^2
    EXPECT_NEAR(point.deviator_stress(), std::sqrt((2500.0 + 1600.0 + 100.0) / 2.0 + 1200.0) * 1e3, 1e-6);
}

TEST(ElementTest, AStressControlledTestGoesOnAfterLiquefactionForTheCyclesAskedFor)
{
    const UbcSand law = nevada();
    const CyclicTest ends = shear_cyclically(law, {}, StressCycles{0.2, 30.0, 0.5, 3.0});
    ASSERT_TRUE(ends.cycles_to_ru_95);
    // the first step of the leg after them is the last
    EXPECT_NEAR(ends.path.back().cycle, *ends.cycles_to_ru_95 + 3.0 - 0.25, 0.01);
}

TEST(ElementTest, AnEllipticLoopHasItsModulusAndDamping)
{
    // tau = G gamma_a cos(2 pi N) turned by a phase d against gamma: secant G cos(d) at the peaks of gamma,
    // area pi G gamma_a^2 sin(d), damping ratio tan(d)/2
    const double G = 30e6, gamma = 1e-3, d = 0.2, pi = 3.14159265358979;
    ElementPath path;
    for (int k = 0; k <= 4000; ++k) {
        ElementPoint point;
        point.cycle = 0.25 + k / 2000.0;
        point.gamma = gamma * std::cos(2.0 * pi * k / 2000.0);
        point.tau = G * gamma * std::cos(2.0 * pi * k / 2000.0 + d);
        point.ru = k / 4000.0;
        path.push_back(point);
    }
    const std::vector<CycleSummary> cycles = summarize_cycles(path);
    ASSERT_EQ(cycles.size(), 2u);
    for (const CycleSummary& cycle : cycles) {
        EXPECT_NEAR(cycle.gamma, gamma, 1e-9);
        EXPECT_NEAR(cycle.secant_modulus, G * std::cos(d), 1e-5 * G);
        EXPECT_NEAR(cycle.damping_ratio, 0.5 * std::tan(d), 1e-5);
    }
    EXPECT_EQ(cycles[1].cycle, 2);
    EXPECT_NEAR(cycles[0].ru, 0.5, 1e-9);
}

TEST(ElementTest, SmallStrainCyclesAreElasticAndLargerOnesSofterAndDampMore)
{
    const UbcSand law = nevada();
    const auto first = [&](double gamma) {
        return summarize_cycles(shear_cyclically(law, {}, StrainCycles{gamma, 2.0}).path).at(0);
    };
    const CycleSummary small = first(1e-6), medium = first(1e-4), large = first(1e-3);
    const double G = law.G_atm * std::sqrt(0.75); // s = 75 kPa
    EXPECT_NEAR(small.secant_modulus, G, 0.01 * G);
    EXPECT_LT(small.damping_ratio, 0.01);
    EXPECT_LT(medium.secant_modulus, small.secant_modulus);
    EXPECT_LT(large.secant_modulus, 0.5 * medium.secant_modulus);
    EXPECT_GT(medium.damping_ratio, small.damping_ratio);
    EXPECT_GT(large.damping_ratio, medium.damping_ratio);
}

TEST(ElementTest, TheStrengthCurveHasItsTwoNumbers)
{
    const UbcSand law = nevada();
    const auto strength = cyclic_strength(law, {});
    ASSERT_TRUE(strength);
    EXPECT_DOUBLE_EQ(strength->csr_15, csr_to_ru_95(law, {}, 15.0).value());
    EXPECT_NEAR(strength->csr_15, 0.146, 0.002);
    EXPECT_GT(strength->slope, 0.25);
    EXPECT_LT(strength->slope, 0.36);
}

} // namespace
} // namespace quicksand
