// Soil at rest stays at rest in implicit steps of hours, wherever the grid lies.
#include "tests/fixtures/wedge_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

TEST(LongRest, ChangesNoStress)
{
    // of 30 kPa at the base; what settling has left out of balance goes on
    for (const Vector2& origin : {Vector2(-0.5, -0.5), Vector2(-0.61, -0.57), Vector2(-0.53, -0.69)}) {
        AssembledCase wedge = settled_wedge(origin, 1e-7);
        EXPECT_LT(change_of_vertical_stress(1e5, wedge), 1.0) << origin.transpose();
    }
}

} // namespace
} // namespace quicksand
