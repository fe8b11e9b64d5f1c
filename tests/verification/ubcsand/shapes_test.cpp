// Monotonic simple shear of UBCSAND against reference numbers: phase transformation, peaks and strain
// hardening.
#include "solver/element/element_laboratory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

const ElementPoint& nearest(const ElementPath& path, double gamma)
{
    return *std::min_element(path.begin(), path.end(), [&](const ElementPoint& a, const ElementPoint& b) {
        return std::abs(a.gamma - gamma) < std::abs(b.gamma - gamma);
    });
}

/// Phase transformation: the least mean stress.
const ElementPoint& phase_transformation(const ElementPath& path)
{
    return *std::min_element(path.begin(), path.end(), [](const ElementPoint& a, const ElementPoint& b) {
        return a.sigma_x + a.sigma_y < b.sigma_x + b.sigma_y;
    });
}

/// tau and sigma'_v within 3 % and what rounding the reference to 0.1 kPa allows.
void expect_stress(const ElementPoint& point, double tau_kpa, double sigma_kpa)
{
    EXPECT_NEAR(point.tau / 1e3, tau_kpa, 0.03 * tau_kpa);
    EXPECT_NEAR(point.sigma_y / 1e3, sigma_kpa, 0.03 * sigma_kpa);
}

struct Shape {
    double n1_60, k0;
    double gamma_pt, tau_pt, sigma_pt;                     // [%, kPa, kPa]
    double tau_1, sigma_1, tau_2, sigma_2, tau_5, sigma_5; // at 1, 2 and 5 % [kPa]; zero where not given
};

class UbcSandShape : public testing::TestWithParam<Shape> {};

TEST_P(UbcSandShape, FollowsTheReference)
{
    const Shape& shape = GetParam();
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(shape.n1_60));
    const ElementPath path = shear_monotonically(law, {100e3, shape.k0}, Drainage::undrained, 0.05);
    const ElementPoint& transformation = phase_transformation(path);
    EXPECT_NEAR(100.0 * transformation.gamma, shape.gamma_pt, 0.03 * shape.gamma_pt);
    expect_stress(transformation, shape.tau_pt, shape.sigma_pt);
    expect_stress(nearest(path, 0.01), shape.tau_1, shape.sigma_1);
    expect_stress(nearest(path, 0.02), shape.tau_2, shape.sigma_2);
    expect_stress(nearest(path, 0.05), shape.tau_5, shape.sigma_5);
}

INSTANTIATE_TEST_SUITE_P(
    Undrained, UbcSandShape,
    testing::Values(Shape{5.0, 0.5, 1.11, 16.5, 30.3, 16.4, 30.5, 18.2, 32.9, 23.9, 43.2},
                    Shape{5.0, 1.0, 1.01, 7.9, 14.5, 7.9, 14.4, 9.1, 16.5, 13.3, 24.0},
                    Shape{10.0, 0.5, 0.35, 30.0, 55.0, 34.5, 61.7, 40.9, 73.1, 63.4, 113.0},
                    Shape{13.9, 0.5, 0.18, 34.8, 64.4, 44.4, 78.6, 55.8, 98.9, 98.0, 174.0},
                    Shape{15.0, 1.0, 0.225, 36.3, 66.7, 46.6, 82.2, 59.6, 105.0, 108.0, 191.0},
                    Shape{20.0, 0.5, 0.085, 37.9, 74.8, 67.0, 114.0, 103.0, 175.0, 257.0, 437.0}));

TEST(UbcSandShapes, LooseSandPeaksAndSoftensAndMediumSandDoesNot)
{
    const auto peak = [](double n1_60, double k0) {
        const UbcSand law = make_ubcsand(ubcsand_from_blow_count(n1_60));
        const ElementPath path = shear_monotonically(law, {100e3, k0}, Drainage::undrained, 0.05);
        for (std::size_t k = 1; k < path.size(); ++k) {
            if (path[k].tau < path[k - 1].tau) return path[k - 1];
        }
        return ElementPoint{};
    };
    EXPECT_NEAR(peak(5.0, 0.5).tau, 23.5e3, 0.03 * 23.5e3);
    EXPECT_NEAR(peak(5.0, 0.5).gamma, 0.0010, 0.0001);
    EXPECT_NEAR(peak(5.0, 1.0).tau, 11.5e3, 0.03 * 11.5e3);
    EXPECT_NEAR(peak(5.0, 1.0).gamma, 0.0024, 0.0001);
    EXPECT_EQ(peak(10.0, 0.5).tau, 0.0);
    EXPECT_EQ(peak(20.0, 0.5).tau, 0.0);
}

TEST(UbcSandShapes, DrainedShearContractsDilatesAndBringsTheLateralStressUp)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(13.9));
    const ElementPath path = shear_monotonically(law, {}, Drainage::drained, 0.05);
    EXPECT_NEAR(nearest(path, 0.001).tau, 38.9e3, 0.03 * 38.9e3);
    EXPECT_NEAR(nearest(path, 0.005).tau, 56.9e3, 0.03 * 56.9e3);
    EXPECT_NEAR(nearest(path, 0.010).tau, 57.1e3, 0.03 * 57.1e3);
    EXPECT_NEAR(nearest(path, 0.005).volumetric_strain(), 0.00034, 0.03 * 0.00034);
    EXPECT_NEAR(path.back().volumetric_strain(), -0.00057, 0.03 * 0.00057);
    EXPECT_NEAR(path.back().sigma_x, 102e3, 0.03 * 102e3);
    for (const ElementPoint& point : path) EXPECT_NEAR(point.sigma_y, 100e3, 1.0);
}

} // namespace
} // namespace quicksand
