#include "solver/element_test_cyclic.hpp"
#include "solver/failure.hpp"

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
    EXPECT_EQ(specimen.state.sigma_y, 200e3);
    EXPECT_EQ(specimen.state.sigma_x, 120e3);
    EXPECT_EQ(specimen.state.sigma_z, 120e3);
    EXPECT_EQ(specimen.state.tau_xy, 15e3);
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
        EXPECT_LE(std::abs(test.path[k].tau - test.path[k - 1].tau), 0.0141 * 10e3);
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
    const double csr = csr_to_ru_95(law, {}, 7.0);
    const CyclicTest test = shear_cyclically(law, {}, StressCycles{csr, 20.0, 0.5, true});
    EXPECT_EQ(test.cycles_to_ru_95.value_or(0.0), 7.0);
}

} // namespace
} // namespace quicksand
