#include "geometry/section/region_locator.hpp"
#include "geometry/section/section.hpp"
#include "tests/fixtures/scratch_files.hpp"

namespace quicksand {
namespace {

/// A trapezoid with a square hole on a foundation.
Section dike_on_foundation()
{
    const Polygon dike = {{{2, 1}, {8, 1}, {6, 3}, {4, 3}},
                          {{{4.5, 1.5}, {4.5, 2.5}, {5.5, 2.5}, {5.5, 1.5}}}};
    return make_section({{"foundation", {rectangle(0, 0, 10, 1)}}, {"dike", {dike}}});
}

TEST(Section, AreaTakesHolesOut)
{
    const Section section = dike_on_foundation();
    EXPECT_DOUBLE_EQ(area(section.regions[0]), 10.0);
    EXPECT_DOUBLE_EQ(area(section.regions[1]), 7.0);
}

TEST(Section, AreaKeepsItsDigitsFarFromTheOrigin)
{
    const Region far{"far", {rectangle(6e5, 6e6, 6e5 + 0.25, 6e6 + 0.5)}};
    EXPECT_DOUBLE_EQ(area(far), 0.125);
}

struct ThicknessCase {
    Vector2 point;
    double foundation, dike;
};

class Thickness : public testing::TestWithParam<ThicknessCase> {};

TEST_P(Thickness, IsTheSoilAboveThePoint)
{
    const std::vector<double> thickness = thickness_above(dike_on_foundation(), GetParam().point);
    EXPECT_NEAR(thickness.at(0), GetParam().foundation, 1e-14);
    EXPECT_NEAR(thickness.at(1), GetParam().dike, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Places, Thickness,
                         testing::Values(ThicknessCase{{1.0, 0.25}, 0.75, 0.0}, // beside the dike
                                         ThicknessCase{{3.0, 0.5}, 0.5, 1.0},   // under the slope
                                         ThicknessCase{{5.0, 0.0}, 1.0, 1.0},   // through the hole
                                         ThicknessCase{{5.0, 2.0}, 0.0, 0.5},   // in the hole
                                         ThicknessCase{{4.0, 1.0}, 0.0, 2.0},   // on a vertex of the crest
                                         ThicknessCase{{4.5, 1.0}, 0.0, 1.0},   // along the hole's side
                                         ThicknessCase{{0.0, 0.0}, 1.0, 0.0},   // at the left end
                                         ThicknessCase{{10.0, 0.0}, 1.0, 0.0},  // at the right end
                                         ThicknessCase{{11.0, 0.0}, 0.0, 0.0},  // beside the soil
                                         ThicknessCase{{5.0, 9.0}, 0.0, 0.0})); // above it

TEST(RegionLocator, GivesAPointOnASharedEdgeToExactlyOneRegion)
{
    // the diagonal's points are not all representable: exact predicates must agree for both owners
    const Region lower{"lower", {{{{0, 0}, {3, 0}, {3, 0.7}}, {}}}},
        upper{"upper", {{{{0, 0}, {3, 0.7}, {0, 0.7}}, {}}}};
    for (int k = 1; k < 300; ++k) {
        const Vector2 point = k / 300.0 * Vector2(3.0, 0.7);
        EXPECT_NE(contains(lower.polygons[0], point), contains(upper.polygons[0], point)) << k;
    }
}

TEST(RegionLocator, FindsNothingInHolesAndOutside)
{
    const Section section = dike_on_foundation();
    const RegionLocator locator(section);
    EXPECT_EQ(locator.locate({5.0, 0.5}), 0u);
    EXPECT_EQ(locator.locate({4.2, 2.0}), 1u);
    EXPECT_FALSE(locator.locate({5.0, 2.0}));
    EXPECT_FALSE(locator.locate({2.0, 2.5}));
}

} // namespace
} // namespace quicksand
