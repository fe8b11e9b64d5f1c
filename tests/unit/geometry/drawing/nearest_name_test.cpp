// Which of several names a misspelt one is taken for.
#include "geometry/drawing/nearest_name.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(NearestName, IsTheNearestAndNotTheFirst)
{
    EXPECT_EQ(nearest_name("crest_hight", {"crest_width", "crest_height"}), "crest_height");
    EXPECT_EQ(nearest_name("k", {"", "q", "k"}), "k");
}

TEST(NearestName, CountsASwapOfNeighboursOnce)
{
    EXPECT_EQ(nearest_name("abc", {"acb"}), "acb");
    EXPECT_EQ(nearest_name("abc", {"cab"}), "");
}

TEST(NearestName, IsNoneBeyondAThirdOfTheLetters)
{
    EXPECT_EQ(nearest_name("porosity", {"density"}), "");
    EXPECT_EQ(nearest_name("porosity", {}), "");
}

} // namespace
} // namespace quicksand
