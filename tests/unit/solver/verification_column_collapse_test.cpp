#include "solver/verification/column_collapse.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

TEST(LubeScaling, TheTwoLawsOfTheRunout)
{
    EXPECT_NEAR(lube_runout_ratio(1.0).value(), 1.2, 1e-14);
    EXPECT_NEAR(lube_runout_ratio(8.0).value(), 7.6, 1e-12);
    EXPECT_FALSE(lube_runout_ratio(2.0).has_value());
}

TEST(LubeScaling, FinalHeight)
{
    EXPECT_EQ(lube_final_height_ratio(0.5), 0.5);
    EXPECT_NEAR(lube_final_height_ratio(32.0), 2.6, 1e-12);
    // a triangle of the two lengths holds the column's area roughly
    const double area = 0.5 * lube_final_height_ratio(5.0) * (1.0 + lube_runout_ratio(5.0).value());
    EXPECT_NEAR(area / 5.0, 0.8, 0.2);
}

TEST(Ritter, FrontAndProfile)
{
    EXPECT_NEAR(ritter_front(1.0, 0.5), std::sqrt(9.81), 1e-14);
    const double depth = 2.0, t = 0.7, wave = std::sqrt(9.81 * depth) * t;
    EXPECT_NEAR(ritter_depth(depth, 0.0, t), 4.0 / 9.0 * depth, 1e-14);
    EXPECT_NEAR(ritter_depth(depth, -wave, t), depth, 1e-14);
    EXPECT_NEAR(ritter_depth(depth, ritter_front(depth, t), t), 0.0, 1e-14);
}

TEST(Ritter, KeepsItsVolume)
{
    const double depth = 2.0, t = 0.7, wave = std::sqrt(9.81 * depth) * t;
    constexpr int strips = 30000;
    double lost = 0.0, gained = 0.0;
    for (int i = 0; i < strips; ++i) {
        const double x = -wave + (i + 0.5) * 3.0 * wave / strips;
        const double strip = 3.0 * wave / strips;
        (x < 0.0 ? lost : gained) += strip * (ritter_depth(depth, x, t) - (x < 0.0 ? depth : 0.0));
    }
    EXPECT_NEAR(gained / -lost, 1.0, 1e-7);
}

} // namespace
} // namespace quicksand
