// What a steady flow at the start refuses.
#include "tests/fixtures/dam_example.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

std::string message_of_text(const std::string& text, const Section& section = dam_section())
{
    const SceneFolder folder;
    folder.write("drawing.geo", "Point(1) = {0, 0, 0};\n");
    return folder.assembly_message(text, section);
}

std::string message(const DamScene& dam, const Section& section = dam_section())
{
    return message_of_text(text_of(dam), section);
}

TEST(InitialFlow, RefusesADrawnLine)
{
    DamScene dam;
    dam.water += "\nphreatic_line = [[0, 11], [16, 3]]";
    EXPECT_EQ(
        message(dam),
        R"(scene.toml:11:17: error[phreatic-line]: water.phreatic_line is given, and water.initial_flow = "seepage" computes it
   11 | phreatic_line = [[0, 11], [16, 3]]
      |                 ^~~~~~~~~~~~~~~~~~
expected: one of both
hint: remove the line, or set initial_flow = "still"
)");
}

TEST(InitialFlow, RefusesWaterBelowTheLevel)
{
    DamScene dam;
    dam.left = "water = \"head\"\nhead = 2";
    EXPECT_EQ(
        message(dam),
        R"(scene.toml:18:8: error[initial-flow]: the water at the curve "left" stands 2 m high at [0, 0], below the water level 3 m
   18 | head = 2
      |        ^
expected: water at the water level or above, and no suction
hint: let level be that of the lowest water
)");
    dam.left += "\nramp_time = \"1 s\"";
    EXPECT_EQ(message(dam), "") << "it falls later";
    dam.left = "water = \"head\"\nhead = -1";
    EXPECT_NE(message(dam).find("the water at the curve \"left\" stands no higher than the curve at [0, 0], "
                                "below the water level 3 m"),
              std::string::npos)
        << message(dam);
}

// Pressures do not fall below the level: a slope had the factor of a full river after its drawdown.
TEST(InitialFlow, RefusesWaterThatFallsBelowTheLevelInTime)
{
    DamScene dam;
    dam.left = "water = \"head\"\nhead = 2\nramp_time = \"1 h\"";
    dam.rest = "[[stages]]\nname = \"fall\"\nkind = \"seepage\"\nduration = \"1 d\"\n";
    EXPECT_NE(
        message(dam).find("the water at the curve \"left\" stands 2 m high at [0, 0] after 3600 s, below "
                          "the water level 3 m"),
        std::string::npos)
        << message(dam);
}

TEST(InitialFlow, WarnsOfARampInASteadyFlow)
{
    DamScene dam;
    dam.left = "water = \"head\"\nhead = 11\nramp_time = \"1 h\"";
    dam.rest = "[[stages]]\nname = \"steady\"\nkind = \"seepage\"\n";
    const std::string told =
        "warning[initial-flow]: the water at the curve \"left\" changes in time, but a stage "
        "of seepage without a duration has the steady flow of its start";
    EXPECT_NE(message(dam).find(told), std::string::npos) << message(dam);
    dam.rest += "duration = \"1 d\"\n";
    EXPECT_EQ(message(dam).find(told), std::string::npos) << message(dam);
}

TEST(InitialFlow, RefusesSuction)
{
    DamScene dam;
    dam.left = "water = \"pore_pressure\"\npore_pressure = -5e3";
    EXPECT_EQ(
        message(dam),
        R"(scene.toml:18:17: error[initial-flow]: the water at the curve "left" stands 11.49 m high at [0, 12], below the curve itself
   18 | pore_pressure = -5e3
      |                 ^~~~
expected: water at the water level or above, and no suction
hint: let level be that of the lowest water
)");
}

TEST(InitialFlow, NeedsGravity)
{
    DamScene dam;
    dam.rest = "[gravity]\nacceleration = 0\n";
    const std::string said = message(dam);
    EXPECT_EQ(
        said.substr(0, said.find("scene.toml:41")),
        R"(scene.toml:10:16: error[initial-flow]: water.initial_flow = "seepage" without gravity: nothing drives the water
   10 | initial_flow = "seepage"
      |                ^~~~~~~~~
expected: gravity.acceleration of more than 0
)");
}

TEST(InitialFlow, RefusesSealsInsideTheSoil)
{
    DamScene dam;
    dam.rest = "[boundaries.border]\nsoil = \"fixed\"\n";
    Section section = dam_section();
    section.curves.push_back({"border", {{{8.0, 0.0}, {8.0, 12.0}}}});
    EXPECT_EQ(
        message(dam, section),
        R"(scene.toml:40:1: error[initial-flow]: the curve "border" lies inside the soil and is impervious or has a head: the steady flow knows curves on the rim alone
   40 | [boundaries.border]
      | ^~~~~~~~~~~~~~~~~~~
expected: curves on the rim of the soil, or water = "drained", which does nothing inside
hint: a cut-off is a thin region of a small hydraulic_conductivity
)");
    dam.rest = "[boundaries.border]\nsoil = \"free\"\n";
    EXPECT_EQ(message(dam, section), "");
}

TEST(InitialFlow, NeedsConductivitiesWhateverTheFlow)
{
    for (const std::string flow : {"drained", "undrained"}) {
        DamScene dam;
        dam.water += "\nflow = \"" + flow + "\"";
        EXPECT_EQ(message(dam), "");
        dam.west = "1e-3 #"; // to be found once
        const std::string said =
            message_of_text(replaced(text_of(dam), "hydraulic_conductivity = 1e-3 #", ""));
        EXPECT_NE(said.find("error[missing-key]: [materials.west] has no hydraulic_conductivity"),
                  std::string::npos)
            << said;
    }
}

TEST(InitialFlow, SaysThatNoLineIsFound)
{
    DamScene dam;
    dam.west = dam.east = "1e-320"; // whose products are 0
    const std::string said = message(dam);
    EXPECT_EQ(
        said.substr(0, said.find("scene.toml:27")),
        R"(scene.toml:10:16: error[initial-flow]: the phreatic line of the flow is not found: after 1 iterations it still moves
   10 | initial_flow = "seepage"
      |                ^~~~~~~~~
expected: a flow with a steady state
hint: look for a wrong conductivity, or draw the line with water.phreatic_line
)");
}

TEST(InitialFlow, WarnsOfUnlikeTiedSides)
{
    // the river stands on a part of the crest, the land beside it is drained
    DamScene dam;
    dam.water = "level = 3\ninitial_flow = \"seepage\"";
    std::string text = text_of(dam);
    text = replaced(text, "[boundaries.left]\nsoil = \"roller\"\nwater = \"head\"\nhead = 11",
                    "[boundaries.left]\nsoil = \"tied\"\ntied_to = \"right\"");
    text = replaced(text, "[boundaries.right]\nsoil = \"roller\"\nwater = \"drained\"",
                    "[boundaries.right]\nsoil = \"tied\"\ntied_to = \"left\"\n[boundaries.river]\nsoil = "
                    "\"free\"\nwater = \"head\"\nhead = 13\n[boundaries.drain]\nsoil = \"fixed\"\nwater = "
                    "\"pore_pressure\"\npore_pressure = \"29.43 kPa\"");
    Section section = dam_section();
    section.curves[0].segments = {{{0, 0}, {8, 0}}};
    section.curves[2].segments = {{{16, 12}, {8, 12}}};
    section.curves.push_back({"river", {{{8, 12}, {0, 12}}}});
    section.curves.push_back({"drain", {{{8, 0}, {16, 0}}}});
    const std::string said = message_of_text(text, section);
    EXPECT_NE(said.find(R"(warning[initial-flow]: the water stands 13 m high at the tied side "left" and )"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find(R"( m at "right": a common side has one pore water pressure)"), std::string::npos)
        << said;
}

} // namespace
} // namespace quicksand
