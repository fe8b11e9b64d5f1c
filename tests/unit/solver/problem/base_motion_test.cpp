#include "solver/problem/base_motion.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(SineMotion, RisesOverItsRampAndEndsWithItsLastCycle)
{
    const BaseMotion motion = SineMotion{10.0, 2.0, 5.0, 2.0};
    EXPECT_EQ(base_acceleration(motion, -0.1), 0.0);
    EXPECT_NEAR(base_acceleration(motion, 0.125), 10.0 * 0.125,
                1e-12); // quarter of the first cycle: an eighth of the ramp
    EXPECT_NEAR(base_acceleration(motion, 1.625), 10.0, 1e-12);
    EXPECT_EQ(base_acceleration(motion, 2.501), 0.0);
    EXPECT_EQ(duration(motion), 2.5);
}

TEST(SampledMotion, IsLinearBetweenItsSamplesAndZeroOutside)
{
    const BaseMotion motion = SampledMotion{0.1, {0.0, 2.0, -4.0}};
    EXPECT_NEAR(base_acceleration(motion, 0.05), 1.0, 1e-12);
    EXPECT_NEAR(base_acceleration(motion, 0.15), -1.0, 1e-12);
    EXPECT_EQ(base_acceleration(motion, 0.2), -4.0);
    EXPECT_EQ(base_acceleration(motion, 0.21), 0.0);
    EXPECT_EQ(base_acceleration(motion, -0.01), 0.0);
    EXPECT_DOUBLE_EQ(duration(motion), 0.2);
}

TEST(NoMotion, IsStill)
{
    EXPECT_EQ(base_acceleration(NoMotion{}, 1.0), 0.0);
    EXPECT_EQ(duration(NoMotion{}), 0.0);
}

} // namespace
} // namespace quicksand
