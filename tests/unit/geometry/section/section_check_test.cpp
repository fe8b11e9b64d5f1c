#include "geometry/section/region_overlay.hpp"
#include "geometry/section/section_check.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <cmath>

namespace quicksand {
namespace {

using Kind = OutlineFault::Kind;

struct FaultCase {
    const char* name;
    std::vector<Region> regions;
    std::vector<Kind> faults;
    double area = 0.0; // of the first fault [m2]
};

class OutlineFaults : public testing::TestWithParam<FaultCase> {};

TEST_P(OutlineFaults, AreFoundWithTheirArea)
{
    const std::vector<OutlineFault> faults = find_outline_faults(make_section(GetParam().regions));
    ASSERT_EQ(faults.size(), GetParam().faults.size());
    for (std::size_t k = 0; k < faults.size(); ++k) EXPECT_EQ(faults[k].kind, GetParam().faults[k]);
    const double found = faults.empty() ? 0.0 : faults.front().area;
    EXPECT_NEAR(found, GetParam().area, 1e-6 * GetParam().area);
}

Polygon frame(const Ring& hole)
{
    return {rectangle(0, 0, 3, 3).outer, {hole}};
}

const Ring clockwise_hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};

INSTANTIATE_TEST_SUITE_P(
    Sections, OutlineFaults,
    testing::Values(
        FaultCase{"sound_neighbours", {{"a", {rectangle(0, 0, 2, 1)}}, {"b", {rectangle(0, 1, 2, 2)}}}, {}},
        FaultCase{"t_junction", {{"a", {rectangle(0, 0, 2, 1)}}, {"b", {rectangle(0.3, 1, 1.1, 2)}}}, {}},
        FaultCase{"declared_hole", {{"a", {frame(clockwise_hole)}}}, {}},
        FaultCase{"filled_hole", {{"a", {frame(clockwise_hole)}}, {"b", {rectangle(1, 1, 2, 2)}}}, {}},
        FaultCase{"bow_tie", {{"a", {{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}}}}, {Kind::self_intersection}},
        FaultCase{"spike", {{"a", {{{{0, 0}, {2, 0}, {1, 0}, {1, 1}}, {}}}}}, {Kind::self_intersection}},
        FaultCase{"line",
                  {{"a", {{{{0, 0}, {2, 0}, {2, 0}}, {}}}}, {"b", {rectangle(3, 0, 4, 1)}}},
                  {Kind::too_few_vertices}},
        FaultCase{"hole_outside", {{"a", {frame({{2, 1}, {2, 2}, {4, 2}, {4, 1}})}}}, {Kind::wrong_hole}},
        FaultCase{"overlap",
                  {{"a", {rectangle(0, 0, 2, 1)}}, {"b", {rectangle(0, 0.9, 2, 2)}}},
                  {Kind::overlap},
                  0.2},
        FaultCase{"inside_another",
                  {{"a", {rectangle(0, 0, 3, 3)}}, {"b", {rectangle(1, 1, 2, 2)}}},
                  {Kind::overlap},
                  1.0},
        FaultCase{"partly_filled_hole",
                  {{"a", {frame(clockwise_hole)}}, {"b", {rectangle(1, 1, 2, 1.75)}}},
                  {Kind::gap},
                  0.25},
        FaultCase{
            "sliver", // the upper region leaves the common line by a millimetre
            {{"a", {rectangle(0, 0, 2, 1)}}, {"b", {{{{0, 1}, {1, 1.001}, {2, 1}, {2, 2}, {0, 2}}, {}}}}},
            {Kind::gap},
            0.001},
        FaultCase{"rounding", // far below anything drawn on purpose
                  {{"a", {rectangle(0, 0, 2, 1)}},
                   {"b", {{{{0, 1}, {1, 1 + 1e-12}, {2, 1 - 1e-12}, {2, 2}, {0, 2}}, {}}}}},
                  {}}),
    [](const auto& named) { return named.param.name; });

TEST(SectionCheck, AcceptsASoundSection)
{
    Section section = make_section({{"a", {rectangle(0, 0, 2, 1)}}, {"b", {rectangle(0, 1, 2, 2)}}});
    section.curves.push_back({"base", {{{0, 0}, {1.5, 0}}, {{1.5, 0}, {2, 0}}}});
    section.curves.push_back({"left", {{{0, 2}, {0, 0}}}}); // along both regions
    EXPECT_TRUE(check_section(section, make_grid(0, 0, 0.25, 8, 8)).empty());
}

TEST(SectionCheck, TakesSeparateBodiesAndTangentSlopesForSound)
{
    Ring arc = {{0, 1}}; // a body whose foot leaves the ground tangentially
    for (int k = 0; k <= 40; ++k) arc.emplace_back(1 + std::sin(0.02 * k), 2 - std::cos(0.02 * k));
    arc.emplace_back(0.0, arc.back().y());
    const Section section = make_section(
        {{"ground", {rectangle(0, 0, 5, 1)}}, {"body", {{arc, {}}}}, {"apart", {rectangle(6, 0, 7, 1)}}});
    EXPECT_TRUE(check_section(section, make_grid(0, 0, 0.25, 28, 8)).empty());
}

TEST(SectionCheck, ComparesAThousandVerticesExactly)
{
    Ring upper = {{10, 4}, {0, 4}}, lower = {{0, 0}, {10, 0}};
    for (int k = 0; k <= 1000; ++k) upper.emplace_back(0.01 * k, 2 + 0.1 * std::sin(0.05 * k));
    for (int k = 1000; k >= 0; --k) lower.emplace_back(0.01 * k, 2 + 0.1 * std::sin(0.05 * k));
    Section section = make_section({{"upper", {{upper, {}}}}, {"lower", {{lower, {}}}}});
    EXPECT_TRUE(check_outlines(section).empty());
    section.regions[0].polygons[0].outer[500].y() += 1e-4;
    EXPECT_EQ(check_outlines(section).size(), 1u);
}

} // namespace
} // namespace quicksand
