#include "solver/verification/solutions/column_collapse.hpp"

#include <gtest/gtest.h>

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

} // namespace
} // namespace quicksand
