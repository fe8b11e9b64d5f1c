// Curves whose conditions act on nothing, on two sides or twice; surfaces in no region.
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::column_section;
using fixtures::replaced;
using fixtures::SceneFolder;

TEST(Curves, RefusesALoadWithoutSoilBesideIt)
{
    std::string text = replaced(column_scene, "soil = \"free\"", "soil = \"free\"\npressure = 1000");
    text = replaced(text, "level = 0.3175", "level = 0.4");
    // a needle on the surface, too thin for any material point
    const Vector2 a(0.0, 0.0), b(0.0675, 0.0), c(0.0675, 0.3175), d(0.04, 0.3175), e(0.04 - 1e-9, 0.34),
        f(0.04 - 2e-9, 0.3175), g(0.0, 0.3175);
    const Vector2 tip_1 = 0.5 * (d + e), tip_2 = 0.5 * (e + f);
    Section section = column_section();
    section.regions[0].polygons[0].outer = {a, b, c, d, tip_1, e, tip_2, f, g};
    section.curves[2].segments = {{c, d}, {d, tip_1}, {tip_1, e}, {e, tip_2}, {tip_2, f}, {f, g}};
    section.upper.y() = 0.34;
    EXPECT_EQ(SceneFolder().assembly_message(text, section),
              R"(scene.toml:41:1: error[load]: no material point lies beside a part of the curve "surface"
   41 | [boundaries.surface]
      | ^~~~~~~~~~~~~~~~~~~~
expected: a curve on the rim of the soil
hint: choose a smaller cell_size, or move the curve to the soil
)");
}

TEST(Curves, RefusesAPressureOnACurveWithinSoil)
{
    const std::string text = replaced(column_scene, "[boundaries.surface]",
                                      "[boundaries.inner]\npressure = 1000\n[boundaries.surface]");
    Section section = column_section();
    const Vector2 left(0.0, 0.15), right(0.0675, 0.15);
    section.regions[0].polygons = {{{{0.0, 0.0}, {0.0675, 0.0}, right, left}, {}},
                                   {{left, right, {0.0675, 0.3175}, {0.0, 0.3175}}, {}}};
    section.curves.push_back({"inner", {{left, right}}});
    EXPECT_EQ(
        SceneFolder().assembly_message(text, section),
        R"(scene.toml:41:1: error[pressed-side]: the pressure on "inner" has soil on both sides at (0.03375, 0.15) m: it has no side to press onto
   41 | [boundaries.inner]
      | ^~~~~~~~~~~~~~~~~~
expected: a pressure on curves with soil on one side
hint: a load within the soil is a traction = [x, y], positive to the right and upward; a stage that buries the curve may give it so in its own table
)");
}

TEST(Curves, RefusesTwoConditionsOfOneLine)
{
    const std::string text = replaced(column_scene, "[boundaries.surface]",
                                      "[boundaries.load]\npressure = 1000\n[boundaries.surface]");
    Section section = column_section();
    Segment turned = section.curves[2].segments.front();
    std::swap(turned.start, turned.end);
    section.curves.push_back({"load", {turned}});
    EXPECT_EQ(
        SceneFolder().assembly_message(text, section),
        R"(scene.toml:43:1: error[shared-curve]: "load" and "surface" are the same line from (0.0675, 0.3175) to (0, 0.3175) m, and both have conditions
   43 | [boundaries.surface]
      | ^~~~~~~~~~~~~~~~~~~~
expected: each line in one physical curve with a table
hint: take it out of one of the physical curves, or remove one of the tables
)");
}

TEST(Curves, TakesASecondNameOfALineForNoCondition)
{
    Section section = column_section();
    section.curves.push_back({"outline", {}});
    for (std::size_t k = 0; k < 4; ++k)
        for (const Segment& segment : section.curves[k].segments)
            section.curves[4].segments.push_back(segment);
    const SceneFolder folder;
    EXPECT_EQ(folder.assembly_message(column_scene, section),
              folder.assembly_message(column_scene, column_section()));
}

TEST(Surfaces, AreToldOfWhereNoRegionHasThem)
{
    Section section = column_section();
    section.nameless = {{{2.0, 0.0}, {4.0, 1.0}}, {{-1.25, 2.0}, {0.0, 3.5}}};
    EXPECT_EQ(
        SceneFolder().assembly_message(column_scene, section),
        R"(scene.toml:5:8: warning[nameless-surface]: surfaces in no physical surface are left out, there is no soil: between (2, 0) and (4, 1), between (-1.25, 2) and (0, 3.5)
    5 | file = "column.geo"
      |        ^~~~~~~~~~~~
hint: name them, as Physical Surface("sand") = {...}; or delete them
to accept it: accept = ["geometry.file"] at the top of the scene
)");
}

} // namespace
} // namespace quicksand
