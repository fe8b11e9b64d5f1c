// Heads, curves and phreatic lines that contradict each other.
#include "tests/fixtures/slope_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::SceneFolder;
using fixtures::slope_scene;
using fixtures::slope_section;

std::string message(const std::string& water, const std::string& ground = "soil = \"free\"",
                    const Section& section = slope_section())
{
    return SceneFolder().assembly_message(slope_scene(water, ground), section);
}

TEST(FaceWater, RefusesAHeadThatContradictsTheLine)
{
    EXPECT_EQ(
        message("level = 1\nphreatic_line = [[0, 5], [12, 5]]", "water = \"head\"\nhead = 3"),
        R"(scene.toml:11:8: error[boundary]: boundaries.ground.head, 3 m, contradicts the phreatic line, which is 5 m high at [12, 2]
   11 | head = 3
      |        ^
expected: the height of the line, or no head: the curve then takes the line's
hint: a variable head begins with the water at rest: give it a ramp_time
)");
    EXPECT_EQ(message("level = 1\nphreatic_line = [[0, 5], [12, 5]]",
                      "water = \"head\"\nhead = 3\nramp_time = \"1 s\""),
              "");
}

TEST(FaceWater, FindsAContradictionBetweenTheEndsOfACurve)
{
    // both agree at the toe and at the crest, not where the water meets the slope
    const std::string said =
        message("level = 1\nphreatic_line = [[4, 2], [8, 3], [12, 3]]", "water = \"head\"\nhead = 3");
    EXPECT_NE(
        said.find("boundaries.ground.head, 3 m, contradicts the phreatic line, which is 2.6667 m high at "
                  "[6.6667, 2.6667]"),
        std::string::npos)
        << said;
}

TEST(FaceWater, RefusesAPorePressureThatContradictsTheLine)
{
    const std::string said = message("level = 1\nphreatic_line = [[0, 5], [12, 5]]",
                                     "water = \"pore_pressure\"\npore_pressure = \"50 kPa\"");
    EXPECT_NE(
        said.find("error[boundary]: boundaries.ground.pore_pressure, 50000 Pa, contradicts the phreatic "
                  "line, which is 5 m high at [4, 4]"),
        std::string::npos)
        << said;
}

TEST(FaceWater, RefusesAHeadBeforeDrySoil)
{
    EXPECT_EQ(
        message("level = 3", "water = \"head\"\nhead = 4"),
        R"(scene.toml:10:8: error[boundary]: boundaries.ground.head, 4 m, stands against soil at [6, 3] that is dry: the water level is 3 m
   10 | head = 4
      |        ^
expected: no head above the level where there is soil above it
hint: raise water.level, or draw water.phreatic_line; a variable head begins with the water at rest: give it a ramp_time
)");
    EXPECT_EQ(message("level = 3", "water = \"head\"\nhead = 4\nramp_time = \"1 s\""), "");
    EXPECT_EQ(message("level = 4", "water = \"head\"\nhead = 5"), "") << "all soil is wet";
}

TEST(FaceWater, RefusesOpenWaterThatIsNotLevel)
{
    EXPECT_EQ(
        message("level = 1\nphreatic_line = [[0, 5], [12, 3]]"),
        R"(scene.toml:8:17: error[phreatic-line]: above the curve "ground" the phreatic line varies from 3 to 5 m, between x = 0 and 12 m: water outside the soil stands level
    8 | phreatic_line = [[0, 5], [12, 3]]
      |                 ^~~~~~~~~~~~~~~~~
expected: a line that is level above the ground, and in the soil elsewhere
hint: let it enter the soil where the water meets the slope
)");
    EXPECT_EQ(message("level = 1\nphreatic_line = [[0, 3.8], [6, 3], [12, 3]]"), "");
    EXPECT_EQ(message("level = 1\nphreatic_line = [[0, 3.5], [6, 2.9], [8, 2], [12, 2]]"), "");
}

TEST(FaceWater, RefusesAnEdgeWithoutANameBelowTheLine)
{
    Section section = slope_section();
    section.curves[2].segments.pop_back();
    EXPECT_EQ(message("level = 1\nphreatic_line = [[0, 3.5], [6, 2.9], [8, 2], [12, 2]]", "soil = \"free\"",
                      section),
              "");
    section.curves[2].segments.erase(section.curves[2].segments.begin());
    EXPECT_EQ(
        message("level = 1\nphreatic_line = [[0, 3.8], [6, 3], [12, 3]]", "soil = \"free\"", section),
        R"(scene.toml:8:17: error[phreatic-line]: the edge of the soil from [12, 2] to [8, 2] lies below the phreatic line and is no physical curve: nothing holds its water
    8 | phreatic_line = [[0, 3.8], [6, 3], [12, 3]]
      |                 ^~~~~~~~~~~~~~~~~~~~~~~~~~~
expected: a physical curve along every edge below the line
hint: name it in the drawing; it then takes the line's head, or what its table says
)");
}

TEST(FaceWater, WarnsOfALineBesideTheSoil)
{
    EXPECT_EQ(
        message("level = 1\nphreatic_line = [[0, 5], [12, 3]]", "soil = \"free\"",
                slope_section({1000.0, 0.0})),
        R"(scene.toml:8:17: warning[phreatic-line]: the phreatic line, from x = 0 to 12 m, lies beside the soil: its end, 3 m, counts everywhere
    8 | phreatic_line = [[0, 5], [12, 3]]
      |                 ^~~~~~~~~~~~~~~~~
expected: points across the section, x = 1000 to 1012 m
to accept it: accept = ["water.phreatic_line"] at the top of the scene
)");
}

TEST(FaceWater, WarnsOfALineThatDiffersBetweenTiedSides)
{
    const std::string text =
        fixtures::replaced(fixtures::column_scene, "level = 0.3175",
                           "level = 0.1\nphreatic_line = [[0, 0.25], [0.05, 0.15], [0.06, 0.15]]");
    const std::string said = SceneFolder().assembly_message(text, fixtures::column_section());
    EXPECT_NE(
        said.find("warning[phreatic-line]: the phreatic line is 0.25 m high at the tied side \"left\" and "
                  "0.15 m at \"right\": a common side has one pore water pressure"),
        std::string::npos)
        << said;
}

} // namespace
} // namespace quicksand
