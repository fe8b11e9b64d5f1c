// A section of which some regions have no soil.
#include "geometry/section/present_section.hpp"
#include "geometry/section/section_rim.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

Region box(const std::string& name, double left, double right, double lower, double upper)
{
    return {name, {{{{left, lower}, {right, lower}, {right, upper}, {left, upper}}, {}}}};
}

/// Ground of 4 m, a fill on half of it; one line is the left side of both, another lies between them.
Section ground_and_fill()
{
    Section section;
    section.regions = {box("ground", 0.0, 4.0, 0.0, 2.0), box("fill", 0.0, 2.0, 2.0, 3.0)};
    section.curves = {{"left", {{{0.0, 3.0}, {0.0, 0.0}}}},
                      {"joint", {{{0.0, 2.0}, {2.0, 2.0}}}},
                      {"crest", {{{2.0, 3.0}, {0.0, 3.0}}}}};
    bound_section(section);
    return section;
}

double length(const std::vector<Segment>& segments)
{
    double sum = 0.0;
    for (const Segment& segment : segments) sum += (segment.end - segment.start).norm();
    return sum;
}

TEST(PresentSection, OfAllRegionsIsTheSection)
{
    const Section drawn = ground_and_fill(), present = without_soil_of({false, false}, drawn);
    ASSERT_EQ(present.curves.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(present.curves[k].segments[0].start, drawn.curves[k].segments[0].start);
    EXPECT_EQ(length(rim_of(present)), length(rim_of(drawn)));
}

TEST(PresentSection, CurvesAreLeftWhereSoilLiesBesideThem)
{
    const Section present = without_soil_of({false, true}, ground_and_fill());
    EXPECT_TRUE(present.regions[1].polygons.empty());
    EXPECT_EQ(present.regions[1].name, "fill");
    EXPECT_DOUBLE_EQ(length(rim_of(present)), 12.0);
    EXPECT_EQ(present.upper.y(), 3.0) << "the grid stays";
    EXPECT_TRUE(present.curves[2].segments.empty());
    ASSERT_EQ(present.curves[0].segments.size(), 1U);
    EXPECT_EQ(present.curves[0].segments[0].start, Vector2(0.0, 2.0));
    EXPECT_EQ(present.curves[0].segments[0].end, Vector2(0.0, 0.0));
}

TEST(PresentSection, TheSoilLiesOnTheLeftOfItsCurves)
{
    const Section present = without_soil_of({false, true}, ground_and_fill());
    ASSERT_EQ(present.curves[1].segments.size(), 1U);
    EXPECT_EQ(present.curves[1].segments[0].start, Vector2(2.0, 2.0));
    EXPECT_EQ(present.curves[1].segments[0].end, Vector2(0.0, 2.0));
}

} // namespace
} // namespace quicksand
