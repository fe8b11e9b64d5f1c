#include "io/keys/scene_units.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

double si(const char* text, Dimension dimension)
{
    return to_si(*split_quantity(text), dimension).value();
}

TEST(Quantity, ConvertsToTheNearestDouble)
{
    EXPECT_EQ(si("7.5 mm", Dimension::length), 0.0075);
    EXPECT_EQ(si("60 kPa", Dimension::pressure), 60e3);
    EXPECT_EQ(si("0.35 g", Dimension::acceleration), 0.35 * 9.81);
    EXPECT_EQ(si("1e-5 m/s", Dimension::velocity), 1e-5);
    EXPECT_EQ(si("20 ms", Dimension::time), 0.02);
    EXPECT_EQ(si("2.65 t/m3", Dimension::density), 2650.0);
    EXPECT_EQ(si("40.5 %", Dimension::none), 0.405);
    EXPECT_EQ(si(" +86.4m/day ", Dimension::velocity), 0.001);
}

TEST(Quantity, RefusesUnitsOfOtherDimensions)
{
    EXPECT_FALSE(to_si(*split_quantity("3 kPa"), Dimension::length));
    EXPECT_FALSE(to_si(*split_quantity("3 MN"), Dimension::pressure));
    EXPECT_FALSE(to_si(*split_quantity("3"), Dimension::pressure));
}

TEST(Quantity, NeedsAFiniteNumber)
{
    EXPECT_FALSE(split_quantity("kPa"));
    EXPECT_FALSE(split_quantity(""));
    EXPECT_FALSE(split_quantity("inf m"));
    EXPECT_FALSE(split_quantity("1e999 m"));
}

TEST(NumberText, IsShortAndReadsBack)
{
    EXPECT_EQ(number_text(0.405), "0.405");
    EXPECT_EQ(number_text(2.2e9), "2.2e9");
    EXPECT_EQ(number_text(5.8e-5), "5.8e-5");
    EXPECT_EQ(number_text(60000.0), "60000");
    EXPECT_EQ(number_text(-1e-300), "-1e-300");
    EXPECT_EQ(number_text(0.0), "0");
    EXPECT_EQ(std::stod(number_text(1.0 / 3.0)), 1.0 / 3.0);
}

TEST(PlaceText, HasFourDigitsAndCentimetresOnMaps)
{
    EXPECT_EQ(place_text({7.33149, 0.0}), "(7.331, 0)");
    EXPECT_EQ(place_text({155000.374, -1007.371}), "(155000.37, -1007.37)");
}

TEST(TimeText, IsInTheUnitThatPeopleSay)
{
    EXPECT_EQ(time_text(0.125), "0.125 s");
    EXPECT_EQ(time_text(3600.0), "3600 s");
    EXPECT_EQ(time_text(86400.0), "24 h");
    EXPECT_EQ(time_text(864000.0), "10 d");
}

} // namespace
} // namespace quicksand
