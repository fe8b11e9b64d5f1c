#include "solver/verification/solutions/griffiths_lane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Griffiths and Lane's first example: 2:1, phi = 20 degrees, c / (gamma H) = 0.05.
HomogeneousSlope first_example()
{
    HomogeneousSlope slope;
    slope.friction_angle = 20.0 * degree;
    slope.cohesion = 0.05 * slope.unit_weight * slope.height;
    return slope;
}

/// gamma H F / c of a slope without friction.
double stability_number(double face_angle, double depth_factor)
{
    HomogeneousSlope slope;
    slope.run = 1.0 / std::tan(face_angle);
    slope.cohesion = slope.unit_weight * slope.height;
    slope.depth_factor = depth_factor;
    return critical_circle(slope).factor_of_safety;
}

TEST(GriffithsLane, FirstExampleOnARigidBase)
{
    // Bishop and Morgenstern's charts give 1.380, finite elements 1.4
    EXPECT_NEAR(critical_circle(first_example()).factor_of_safety, 1.380, 0.004);
    EXPECT_NEAR(critical_circle(first_example()).factor_of_safety, 1.3781, 2e-4);
}

TEST(GriffithsLane, FoundationLayerAndEarthquake)
{
    HomogeneousSlope slope = first_example();
    slope.depth_factor = 1.5;
    EXPECT_NEAR(critical_circle(slope).factor_of_safety, 1.369, 6e-4);
    slope = first_example();
    slope.seismic_coefficient = 0.1;
    EXPECT_NEAR(critical_circle(slope).factor_of_safety, 1.1089, 2e-4);
}

TEST(GriffithsLane, CriticalCircleStaysAboveTheBase)
{
    const SlipCircle circle = critical_circle(first_example()).circle;
    EXPECT_GE(circle.centre_y - circle.radius, -1e-6);
    EXPECT_GE(circle.centre_y, 10.0);
}

TEST(GriffithsLane, FrictionlessSlopesHaveTaylorsStabilityNumbers)
{
    // Taylor 1937: 0.219, 0.191 for faces of 75, 60 degrees; 0.181 far above a deep base
    EXPECT_NEAR(1.0 / stability_number(75.0 * degree, 1.0), 0.219, 1e-3);
    EXPECT_NEAR(1.0 / stability_number(60.0 * degree, 1.0), 0.191, 1e-3);
    EXPECT_NEAR(1.0 / stability_number(std::atan(0.5), 4.0), 0.181, 4e-3);
}

TEST(GriffithsLane, FrictionlessCircleIsAMomentBalance)
{
    HomogeneousSlope slope = first_example();
    slope.friction_angle = 0.0;
    // a circle through the toe, centre (0, 30): it meets the crest level at x = sqrt(30^2 - 20^2)
    const SlipCircle circle{0.0, 30.0, 30.0};
    const double entry = std::sqrt(500.0), angle = std::asin(entry / 30.0);
    double moment = 0.0;
    constexpr int strips = 100000;
    for (int i = 0; i < strips; ++i) {
        const double x = (i + 0.5) * entry / strips;
        const double depth = std::min(0.5 * x, 10.0) - (30.0 - std::sqrt(900.0 - x * x));
        moment += slope.unit_weight * depth * x * entry / strips;
    }
    const double exact = slope.cohesion * 900.0 * angle / moment;
    EXPECT_NEAR(bishop_factor_of_safety(slope, circle, 0.0, entry) / exact, 1.0, 1e-4);
}

TEST(GriffithsLane, ScalesAndOrders)
{
    HomogeneousSlope slope = first_example();
    const double reference = critical_circle(slope).factor_of_safety;
    slope.height *= 0.1;
    slope.cohesion *= 0.1;
    EXPECT_NEAR(critical_circle(slope).factor_of_safety, reference, 1e-9);
    slope.seismic_coefficient = 0.05;
    const double shaken = critical_circle(slope).factor_of_safety;
    EXPECT_LT(shaken, reference);
    slope.seismic_coefficient = 0.1;
    EXPECT_LT(critical_circle(slope).factor_of_safety, shaken);
    // strength over its factor of safety just stands
    slope = first_example();
    slope.cohesion /= reference;
    slope.friction_angle = std::atan(std::tan(slope.friction_angle) / reference);
    EXPECT_NEAR(critical_circle(slope).factor_of_safety, 1.0, 1e-5);
}

} // namespace
} // namespace quicksand
