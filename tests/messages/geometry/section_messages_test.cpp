// What a user reads when a section can be read but not be sampled.
#include "geometry/sampling/particle_sampler.hpp"
#include "geometry/section/section_check.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <algorithm>
#include <cstdlib>

namespace quicksand {
namespace {

Section two_layers(double top_of_clay, double bottom_of_sand)
{
    return make_section(
        {{"clay", {rectangle(0, 0, 2, top_of_clay)}}, {"sand", {rectangle(0, bottom_of_sand, 2, 2)}}});
}

Section with_curve(Segment segment)
{
    Section section = two_layers(1, 1);
    section.curves.push_back({"base", {segment}});
    return section;
}

Section with_names(const std::string& first, const std::string& second)
{
    Section section = two_layers(1, 1);
    section.regions[0].name = first;
    section.regions[1].name = second;
    return section;
}

Section with_two_curves_and_points_of_one_name()
{
    Section section = with_curve({{0, 0}, {2, 0}});
    section.curves.push_back({"base", {Segment{{0, 2}, {2, 2}}}});
    section.points = {{"toe", {0, 0}}, {"toe", {2, 0}}};
    return section;
}

Section single(const Polygon& polygon)
{
    return make_section({{"sand", {polygon}}});
}

struct SectionMistake {
    const char* name;
    Section section;
    BackgroundGrid grid;
    std::vector<std::string> message; // parts of the one finding
};

const BackgroundGrid covering = make_grid(0, 0, 0.25, 8, 8);

class SectionMessages : public testing::TestWithParam<SectionMistake> {};

TEST_P(SectionMessages, NameTheGroupAndThePlace)
{
    const std::vector<std::string> findings = check_section(GetParam().section, GetParam().grid);
    ASSERT_EQ(findings.size(), 1u) << (findings.empty() ? "" : findings.back());
    for (const std::string& part : GetParam().message) {
        EXPECT_NE(findings.front().find(part), std::string::npos) << "no " << part << " in\n"
                                                                  << findings.front();
    }
    EXPECT_EQ(findings.front().back(), '.');
    if (std::getenv("QUICKSAND_SHOW_MESSAGES") != nullptr) std::cout << findings.front() << "\n";
}

INSTANTIATE_TEST_SUITE_P(
    Sections, SectionMessages,
    testing::Values(
        SectionMistake{"bow_tie",
                       single({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}),
                       covering,
                       {"region \"sand\": its outline meets itself at (1, 1)", "Curve Loop"}},
        SectionMistake{"overlap",
                       two_layers(1.1, 1.0),
                       covering,
                       {"regions \"clay\" and \"sand\" overlap by 0.2 m2 between (0, 1) and (2, 1.1)"}},
        SectionMistake{"overlap_in_one_region",
                       make_section({{"sand", {rectangle(0, 0, 2, 1.1), rectangle(0, 1, 2, 2)}}}),
                       covering,
                       {"two surfaces of region \"sand\" overlap by 0.2 m2 between (0, 1) and (2, 1.1)"}},
        SectionMistake{"flat",
                       single({{{0, 0}, {2, 0}}, {}}),
                       covering,
                       {"region \"sand\" has an outline without area at (0, 0)"}},
        SectionMistake{"gap",
                       make_section({{"clay", {{{{0, 0}, {2, 0}, {2, 1}, {1, 0.9}, {0, 1}}, {}}}},
                                     {"sand", {rectangle(0, 1, 2, 2)}}}),
                       covering,
                       {"between regions \"clay\" and \"sand\" is a gap of 0.1 m2", "(0, 0.9) and (2, 1)"}},
        SectionMistake{"open_slit",
                       two_layers(1.0, 1.002),
                       covering,
                       {"regions \"clay\" and \"sand\" are a slit apart", "misses", "by 0.002 m"}},
        SectionMistake{
            "stray_curve",
            with_curve({{0, 0.1}, {2, 0.1}}),
            covering,
            {"curve \"base\" does not lie on the outline of any region from (0, 0.1) to (2, 0.1)"}},
        SectionMistake{
            "curve_sticks_out", with_curve({{0, 0}, {2.5, 0}}), covering, {"curve \"base\"", "(2.5, 0)"}},
        SectionMistake{"same_names", with_names("sand", "sand"), covering, {"2 regions are called \"sand\""}},
        SectionMistake{"hole_outside",
                       single({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{{1, 1}, {1, 3}, {1.5, 3}, {1.5, 1}}}}),
                       covering,
                       {"region \"sand\": the hole between (1, 1) and (1.5, 3) leaves the region's outline"}},
        SectionMistake{"small_grid",
                       two_layers(1, 1),
                       make_grid(0, 0, 0.25, 8, 7),
                       {"the grid from (0, 0) to (2, 1.75) does not cover region \"sand\"",
                        "needs 8 x 8 cells of 0.25 m from (0, 0)"}},
        SectionMistake{"shifted_grid",
                       two_layers(1, 1),
                       make_grid(0.25, 0, 0.25, 8, 8),
                       {"does not cover region \"clay\""}}),
    [](const auto& named) { return named.param.name; });

TEST(SectionMessages, CountCurvesAndPointsOfOneName)
{
    EXPECT_EQ(check_section(with_two_curves_and_points_of_one_name(), covering),
              (std::vector<std::string>{"2 curves are called \"base\"; give each its own name.",
                                        "2 points are called \"toe\"; give each its own name."}));
}

TEST(SectionMessages, LeaveAThinSeamAlone)
{
    Section section = make_section({{"clay", {rectangle(0, 0, 2, 1)}},
                                    {"seam", {rectangle(0, 1, 2, 1.01)}},
                                    {"sand", {rectangle(0, 1.01, 2, 2)}}});
    EXPECT_TRUE(check_section(section, covering).empty());
    for (Region& region : section.regions) // leaning sides
        for (Vector2& corner : region.polygons.front().outer) corner.x() += 0.3 * corner.y();
    bound_section(section);
    EXPECT_TRUE(check_section(section, make_grid(0, 0, 0.25, 12, 8)).empty());
}

TEST(SectionMessages, LeaveAFloorAloneThatGoesOnBeyondTheSoil)
{
    Section section = two_layers(1, 1);
    section.curves.push_back({"base", {{{0, 0}, {2, 0}}, {{2, 0}, {3, 0}}}});
    EXPECT_TRUE(check_section(section, covering).empty());
}

TEST(SectionMessages, NameAFoldedQuadrilateral)
{
    Section section = single(rectangle(0, 0, 1, 1));
    section.quads.push_back({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 0});
    try {
        sample_mesh(section, covering);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(
            std::string(error.what()).find("quadrilateral at (0.5, 0.5) that is folded, flat or not convex"),
            std::string::npos);
    }
}

} // namespace
} // namespace quicksand
