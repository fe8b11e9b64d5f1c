// Free-field sides that scene and drawing do not allow.
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::column_section;
using fixtures::replaced;
using fixtures::SceneFolder;

std::string free_field_scene()
{
    const std::string text =
        replaced(column_scene, "soil = \"tied\"\ntied_to = \"right\"", "soil = \"free_field\"");
    return replaced(text, "soil = \"tied\"\ntied_to = \"left\"", "soil = \"free_field\"");
}

TEST(FreeFieldSides, OfLevelGroundHaveNothingToSay)
{
    EXPECT_EQ(SceneFolder().assembly_message(free_field_scene(), column_section()), "");
    const std::string drained =
        replaced(free_field_scene(), "soil = \"free_field\"\n\n[boundaries.surface]",
                 "soil = \"free_field\"\nwater = \"drained\"\n\n[boundaries.surface]");
    EXPECT_EQ(SceneFolder().assembly_message(drained, column_section()), "");
}

TEST(FreeFieldSides, AreVerticalLinesOnTheGrid)
{
    Section section = column_section();
    section.curves[3].segments[0].start.x() = 0.01;
    EXPECT_NE(SceneFolder()
                  .assembly_message(free_field_scene(), section)
                  .find("error[free-field]: the free-field curve \"left\" is not a vertical line"),
              std::string::npos);
    const std::string text = replaced(free_field_scene(), "\"7.5 mm\"", "\"8 mm\"");
    EXPECT_NE(SceneFolder()
                  .assembly_message(text, column_section())
                  .find("error[free-field]: the free-field curve \"right\" at x = 0.0675 m is not on a grid "
                        "line: the nearest is at x = 0.064 m"),
              std::string::npos);
}

TEST(FreeFieldSides, AreNotBesideTiedOnes)
{
    const std::string text = replaced(column_scene, "[boundaries.base]\nsoil = \"fixed\"",
                                      "[boundaries.base]\nsoil = \"free_field\"");
    EXPECT_NE(SceneFolder().assembly_message(text, column_section()).find(R"(
expected: sides of one of the two kinds
hint: where the ground of both sides differs, both are free_field
)"),
              std::string::npos);
}

TEST(FreeFieldSides, HaveNoWaterOfTheirOwn)
{
    const std::string text =
        replaced(free_field_scene(), "soil = \"free_field\"\n\n[boundaries.surface]",
                 "soil = \"free_field\"\nwater = \"impervious\"\n\n[boundaries.surface]");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:36:1: error[free-field]: the free-field side "right" has a condition of its own for the water
   36 | [boundaries.right]
      | ^~~~~~~~~~~~~~~~~~
expected: water = "drained", or none; in a computed flow a head as well
hint: water passes the side, with the pore pressure of the ground beyond it
)");
}

TEST(FreeFieldSides, NeedLevelGroundBesideThem)
{
    Section section = column_section();
    const Vector2 top(0.0675, 0.31);
    section.regions[0].polygons[0].outer[2] = top;
    section.curves[1].segments[0].end = top;
    section.curves[2].segments[0].start = top;
    const std::string dry = replaced(free_field_scene(), "level = 0.3175", "level = 0.4");
    const std::string message = SceneFolder().assembly_message(dry, section);
    EXPECT_NE(
        message.find(
            R"(error[free-field]: the free-field side "left" has no column of its own: the ground beside it is not level over the first column of cells)"),
        std::string::npos)
        << message;
    EXPECT_NE(message.find(R"(
expected: level ground over one cell beside the side
hint: draw the surface, the layers, the base and the phreatic line level over the last cells before the side
)"),
              std::string::npos)
        << message;
}

} // namespace
} // namespace quicksand
