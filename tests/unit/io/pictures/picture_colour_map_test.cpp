#include "io/pictures/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

namespace {

double linear_part(double part)
{
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

/// CIE L* of an sRGB colour, 0 black to 100 white.
double lightness(const Colour& colour)
{
    const double luminance = 0.2126 * linear_part(colour.red) + 0.7152 * linear_part(colour.green) +
                             0.0722 * linear_part(colour.blue);
    return luminance > 0.008856 ? 116.0 * std::cbrt(luminance) - 16.0 : 903.3 * luminance;
}

} // namespace

TEST(ColourMap, HasViridisEnds)
{
    EXPECT_EQ(hex_code(map_colour(ColourMap::sequential, 0.0)), "#440154");
    EXPECT_EQ(hex_code(map_colour(ColourMap::sequential, 1.0)), "#fde725");
    EXPECT_EQ(hex_code(map_colour(ColourMap::sequential, -5.0)), "#440154");
    EXPECT_EQ(hex_code(map_colour(ColourMap::sequential, 5.0)), "#fde725");
}

TEST(ColourMap, SequentialLightnessRisesEvenly)
{
    for (int k = 0; k < 64; ++k) {
        const double rise = lightness(map_colour(ColourMap::sequential, (k + 1) / 64.0)) -
                            lightness(map_colour(ColourMap::sequential, k / 64.0));
        EXPECT_NEAR(rise, 76.0 / 64.0, 0.4) << k;
    }
}

TEST(ColourMap, DivergingLightnessFallsAlikeToBothEnds)
{
    for (int k = 0; k < 32; ++k) {
        const double inner = k / 64.0, outer = (k + 1) / 64.0;
        for (const double side : {-1.0, 1.0}) {
            const double fall = lightness(map_colour(ColourMap::diverging, 0.5 + side * inner)) -
                                lightness(map_colour(ColourMap::diverging, 0.5 + side * outer));
            EXPECT_NEAR(fall, 68.0 / 32.0, 0.5) << side * outer;
        }
    }
}

TEST(ColourMap, ShowsWhatIsUndefinedInGrey)
{
    EXPECT_EQ(hex_code(map_colour(ColourMap::sequential, std::nan(""))), hex_code(undefined_colour));
    EXPECT_EQ(hex_code(map_colour(ColourMap::diverging, std::nan(""))), hex_code(undefined_colour));
}

} // namespace quicksand
