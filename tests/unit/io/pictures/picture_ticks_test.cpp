#include "io/pictures/picture_ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

namespace {

const double not_a_number = std::nan("");

} // namespace

TEST(NiceTicks, AreRound)
{
    const Ticks ticks = nice_ticks({0.0, 0.48}, 10);
    EXPECT_DOUBLE_EQ(ticks.step, 0.05);
    EXPECT_EQ(ticks.decimals, 2);
}

TEST(NiceTicks, AreNeverMoreThanAskedFor)
{
    for (const double width : {0.0037, 0.11, 1.0, 9.99, 12345.0})
        for (int at_most = 2; at_most < 13; ++at_most) {
            const Ticks ticks = nice_ticks({-0.37 * width, 0.63 * width}, at_most);
            const double first = std::ceil(-0.37 * width / ticks.step - 1e-9);
            const double last = std::floor(0.63 * width / ticks.step + 1e-9);
            EXPECT_LE(last - first + 1.0, at_most);
            EXPECT_GE(last - first + 1.0, 1.0);
        }
}

TEST(RoundLimits, WidenToRoundNumbersAndOpenAnEmptyInterval)
{
    EXPECT_DOUBLE_EQ(round_limits({0.0, 8937.0}).high, 9000.0);
    EXPECT_DOUBLE_EQ(round_limits({-0.031, 0.0}).low, -0.035);
    const PlotRange around = round_limits({5.0, 5.0});
    EXPECT_LT(around.low, 5.0);
    EXPECT_GT(around.high, 5.0);
    EXPECT_DOUBLE_EQ(round_limits({0.0, 0.0}).width(), 2.0);
}

TEST(DisplayUnit, ChoosesThePrefix)
{
    EXPECT_EQ(display_unit("Pa", 9000.0).text, "kPa");
    EXPECT_EQ(display_unit("Pa", 999.9).text, "kPa");
    EXPECT_EQ(display_unit("m", 0.0123).text, "mm");
    EXPECT_EQ(display_unit("m", 5e-5).text, "µm");
    EXPECT_EQ(display_unit("m", 0.0).text, "m");
    EXPECT_EQ(display_unit("", 3e-5).text, "10⁻⁶");
    EXPECT_EQ(display_unit("", 0.7).text, "");
    EXPECT_EQ(display_unit("", 0.007).text, "10⁻³");
    EXPECT_EQ(display_unit("%", 0.03).text, "%");
    EXPECT_DOUBLE_EQ(display_unit("%", 0.03).factor, 0.01);
    EXPECT_EQ(display_unit("%", 1e-6).text, "10⁻⁶");
    EXPECT_EQ(label_with_unit("Depth", display_unit("m", 3.0)), "Depth [m]");
    EXPECT_EQ(label_with_unit("ru", display_unit("", 1.0)), "ru");
}

TEST(LargestOf, SkipsWhatIsUndefined)
{
    EXPECT_EQ(largest_of({not_a_number, -3.0, 2.0}), 3.0);
    EXPECT_EQ(largest_of({not_a_number}), -1.0);
}

} // namespace quicksand
