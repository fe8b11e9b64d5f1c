#include "geometry/section/section_rim.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

double length_of(const std::vector<Segment>& rim)
{
    double length = 0.0;
    for (const Segment& edge : rim) length += (edge.end - edge.start).norm();
    return length;
}

TEST(SectionRim, LeavesOutWhereRegionsMeet)
{
    // a box of 2 x 2 with a hole of 0.5 x 0.5, and one of 1 x 1 beside it, whose side is a part of the
    // first's
    const Polygon left{{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}},
                       {{{0.5, 0.5}, {0.5, 1.0}, {1.0, 1.0}, {1.0, 0.5}}}};
    const Polygon right{{{2.0, 0.5}, {3.0, 0.5}, {3.0, 1.5}, {2.0, 1.5}}, {}};
    Section section;
    section.regions = {{"left", {left}}, {"right", {right}}};
    const std::vector<Segment> rim = rim_of(section);
    EXPECT_NEAR(length_of(rim), 8.0 + 2.0 + 4.0 - 2.0, 1e-12);
    double twice_area = 0.0; // by Green's theorem: the soil is on the left of all edges
    for (const Segment& edge : rim)
        twice_area += edge.start.x() * edge.end.y() - edge.start.y() * edge.end.x();
    EXPECT_NEAR(0.5 * twice_area, 4.0 - 0.25 + 1.0, 1e-12);
    for (const Segment& edge : rim) {
        const Vector2 middle = 0.5 * (edge.start + edge.end);
        EXPECT_FALSE(std::abs(middle.x() - 2.0) < 1e-9 && middle.y() > 0.5 && middle.y() < 1.5) << middle;
    }
}

} // namespace
} // namespace quicksand
