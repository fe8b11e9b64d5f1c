// Scenes that do not fit their drawings.
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::column_section;
using fixtures::replaced;
using fixtures::SceneFolder;

TEST(Assembly, OfASoundSceneHasNothingToSay)
{
    EXPECT_EQ(SceneFolder().assembly_message(column_scene, column_section()), "");
}

TEST(Assembly, NamesARegionThatTheDrawingLacks)
{
    const std::string text = replaced(column_scene, "[regions.sand]", "[regions.snad]");
    EXPECT_EQ(SceneFolder().assembly_message(text, column_section()),
              R"(scene.toml:5:8: error[missing-table]: the drawing's physical surface "sand" has no material
    5 | file = "column.geo"
      |        ^~~~~~~~~~~~
hint: add a table [regions.sand] with a material
scene.toml:27:1: error[unknown-group]: the drawing has no physical surface "snad"
   27 | [regions.snad]
      | ^~~~~~~~~~~~~~
expected: sand
hint: did you mean "sand"?
)");
}

TEST(Assembly, NamesABoundaryThatTheDrawingLacks)
{
    const std::string text = replaced(column_scene, "[boundaries.surface]", "[boundaries.surfaces]");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:5:8: warning[unnamed-boundary]: the physical curve "surface" has no conditions: it is free and drained
    5 | file = "column.geo"
      |        ^~~~~~~~~~~~
hint: say so with a table [boundaries.surface] and soil = "free"
to accept it: accept = ["boundaries.surface"] at the top of the scene
scene.toml:41:1: error[unknown-group]: the drawing has no physical curve "surfaces"
   41 | [boundaries.surfaces]
      | ^~~~~~~~~~~~~~~~~~~~~
expected: one of base, right, surface, left
hint: did you mean "surface"?
)");
}

TEST(Assembly, DoubtsADrawingThatIsNotInMetres)
{
    Section section = column_section();
    section.upper = section.lower + Vector2(10000.0, 4000.0);
    const std::string message = SceneFolder().assembly_message(column_scene, section);
    EXPECT_EQ(message.substr(0, message.find("to accept it")),
              R"(scene.toml:5:8: warning[plausibility]: the drawing is 10000 m wide and 4000 m high
    5 | file = "column.geo"
      |        ^~~~~~~~~~~~
expected: usually at most 5000 m
hint: coordinates are in metres; Dilate {{0, 0, 0}, 0.001} {Surface{:};} turns millimetres into them
)");
}

TEST(Assembly, AsksForThePlaceOfAProbe)
{
    const std::string text = replaced(column_scene, "at = [0.03, 0.3]\n", "");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:52:1: error[unknown-group]: the probe "crest" has no place: the drawing has no physical point "crest"
   52 | [probes.crest]
      | ^~~~~~~~~~~~~~
expected: the drawing has no physical point at all
hint: give the probe at = [x, y], or name a physical point after it
)");
}

TEST(Assembly, HasNothingToSayOfSoilAboveTheWater)
{
    const std::string text = replaced(column_scene, "level = 0.3175", "level = 0.3");
    EXPECT_EQ(SceneFolder().assembly_message(text, column_section()), "");
}

TEST(Assembly, RefusesAPhreaticLineBelowTheWaterLevel)
{
    const std::string text =
        replaced(column_scene, "level = 0.3175", "level = 0.2\nphreatic_line = [[0, 0.3], [0.0675, 0.1]]");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:18:17: error[phreatic-line]: the point [0.0675, 0.1] of the phreatic line lies below the water level 0.2 m
   18 | phreatic_line = [[0, 0.3], [0.0675, 0.1]]
      |                 ^~~~~~~~~~~~~~~~~~~~~~~~~
expected: points at the water level or above
hint: let level be that of the lowest still water
)");
}

TEST(Assembly, RefusesAPhreaticLineThatTurnsBack)
{
    const std::string text =
        replaced(column_scene, "level = 0.3175", "level = 0.2\nphreatic_line = [[0.05, 0.3], [0.05, 0.2]]");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:18:17: error[phreatic-line]: the point [0.05, 0.2] of the phreatic line does not lie to the right of the one before
   18 | phreatic_line = [[0.05, 0.3], [0.05, 0.2]]
      |                 ^~~~~~~~~~~~~~~~~~~~~~~~~~
expected: points from left to right
)");
}

/// The column with drained water, whose conductivity is of no use, and water beyond a curve.
std::string drained_column(const std::string& water, const std::string& soil, const std::string& outer)
{
    std::string text = replaced(column_scene, "level = 0.3175", water + "\nflow = \"drained\"");
    text = replaced(text, "hydraulic_conductivity = 5.8e-5\n", "");
    return replaced(text, soil, soil + "\n" + outer);
}

TEST(Assembly, RefusesAHeadThatDrainedSoilCannotBalance)
{
    EXPECT_EQ(
        SceneFolder().assembly_message(
            drained_column("level = 0.3175", "soil = \"free\"", "water = \"head\"\nhead = 0.4"),
            column_section()),
        R"(scene.toml:44:8: error[boundary]: boundaries.surface.head has no effect with water.flow = "drained": the pores have the pressure of the still water
   44 | head = 0.4
      |        ^~~
expected: still water at the level 0.3175 m beyond the curve, or water.flow = "coupled" or "undrained"
hint: water that stands in the soil is water.phreatic_line; a load is pressure on a free curve
)");
}

TEST(Assembly, RefusesAPorePressureThatDrainedSoilCannotBalance)
{
    // a phreatic line that rises nowhere above the level is none
    const std::string text =
        drained_column("level = 0.1\nphreatic_line = [[0, 0.1], [0.0675, 0.1]]", "soil = \"fixed\"",
                       "water = \"pore_pressure\"\npore_pressure = \"20 kPa\"");
    const std::string message = SceneFolder().assembly_message(text, column_section());
    EXPECT_NE(message.find("error[boundary]: boundaries.base.pore_pressure has no effect with water.flow = "
                           "\"drained\""),
              std::string::npos)
        << message;
}

TEST(Assembly, HasNothingToSayOfOuterWaterThatDrainedSoilBalances)
{
    const std::string still =
        drained_column("level = 0.3175", "soil = \"free\"", "water = \"head\"\nhead = 0.3175");
    EXPECT_EQ(SceneFolder().assembly_message(still, column_section()), "");
    const std::string risen = drained_column("level = 0.1\nphreatic_line = [[0, 0.25], [0.0675, 0.25]]",
                                             "soil = \"fixed\"", "water = \"head\"\nhead = 0.25");
    EXPECT_EQ(SceneFolder().assembly_message(risen, column_section()), "");
}

TEST(Assembly, RefusesAPhreaticLineOfOnePoint)
{
    const std::string text =
        replaced(column_scene, "level = 0.3175", "level = 0.2\nphreatic_line = [[0.05, 0.3]]");
    EXPECT_EQ(SceneFolder().assembly_message(text, column_section()),
              R"(scene.toml:18:17: error[type]: water.phreatic_line is a list of less than two
   18 | phreatic_line = [[0.05, 0.3]]
      |                 ^~~~~~~~~~~~~
expected: two points or more, as [[0, 1.5], [10, 0.5]]
)");
}

TEST(Assembly, RefusesTiedSidesOffTheGrid)
{
    const std::string text = replaced(column_scene, "\"7.5 mm\"", "0.008");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:37:1: error[tied]: the tied curve "right" at x = 0.0675 m is not on a grid line: the nearest is at x = 0.064 m
   37 | [boundaries.right]
      | ^~~~~~~~~~~~~~~~~~
expected: a vertical straight line on a grid line
hint: choose a cell size that divides the width, or set origin in [grid]
)");
}

TEST(Assembly, RefusesTiedSidesOfUnequalHeight)
{
    Section section = column_section();
    section.curves[3].segments[0].start.y() = 0.25;
    EXPECT_NE(SceneFolder()
                  .assembly_message(column_scene, section)
                  .find("error[tied]: the tied curves \"left\" and \"right\" reach from y = 0 to 0.25 m and "
                        "from 0 to 0.3175 m"),
              std::string::npos);
}

TEST(Assembly, RefusesTiedCurvesOnOneSide)
{
    Section section = column_section();
    section.curves[1].segments = section.curves[3].segments;
    const std::string message = SceneFolder().assembly_message(column_scene, section);
    EXPECT_NE(message.find("error[tied]: the tied curves \"left\" and \"right\" are at the same x = 0 m"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("expected: two opposite sides"), std::string::npos) << message;
}

TEST(Assembly, RefusesTiedCurvesThatAreNotVertical)
{
    Section section = column_section();
    section.curves[3].segments[0].start.x() = 0.01;
    EXPECT_NE(SceneFolder()
                  .assembly_message(column_scene, section)
                  .find("error[tied]: the tied curve \"left\" is not a vertical line"),
              std::string::npos);
}

TEST(Assembly, WarnsOfAKeyThatHasNoEffectAnyMore)
{
    const std::string text = replaced(column_scene, "particles_per_cell = [3, 3]",
                                      "particles_per_cell = [3, 3]\nboundary_refinement = 2");
    EXPECT_EQ(
        SceneFolder().message(text),
        R"(scene.toml:12:1: warning[retired-key]: sampling.boundary_refinement has no effect any more: outlines cut the domains exactly
   12 | boundary_refinement = 2
      | ^~~~~~~~~~~~~~~~~~~
hint: remove the line
to accept it: accept = ["sampling.boundary_refinement"] at the top of the scene
)");
}

TEST(Assembly, TakesWallsAtAnyPlaceOfTheGrid)
{
    const std::string between = replaced(column_scene, "\"7.5 mm\"", "\"7.5 mm\"\norigin = [0, -0.005]");
    EXPECT_EQ(SceneFolder().assembly_message(between, column_section()), "");
    const std::string viscous = replaced(between, "soil = \"fixed\"", "soil = \"viscous\"");
    EXPECT_EQ(SceneFolder().assembly_message(viscous, column_section()), "");

    const std::string moving =
        replaced(column_scene, "soil = \"free\"", "soil = \"moving\"\nnormal_velocity = \"1 mm/s\"");
    Section slanted = column_section();
    const Vector2 top(0.0675, 0.3), left(0.0, 0.3175);
    slanted.regions[0].polygons[0].outer[2] = top;
    slanted.curves[1].segments[0].end = top;
    slanted.curves[2].segments[0] = {top, left};
    EXPECT_EQ(SceneFolder().assembly_message(moving, slanted).find("off-grid"), std::string::npos);
}

TEST(Assembly, WarnsOfAViscousSideOfAShakenSection)
{
    std::string text = replaced(column_scene, "soil = \"tied\"\ntied_to = \"right\"", "soil = \"viscous\"");
    text = replaced(text, "soil = \"tied\"\ntied_to = \"left\"", "soil = \"roller\"");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:33:1: warning[viscous-side]: the viscous side "left" damps the shaking of the ground itself, not only the outgoing waves
   33 | [boundaries.left]
      | ^~~~~~~~~~~~~~~~~
expected: sides tied to each other, or free_field sides, where the base shakes
to accept it: accept = ["boundaries.left"] at the top of the scene
)");
}

TEST(Assembly, WarnsOfALongRunOnAViscousBase)
{
    std::string text = replaced(column_scene, "[boundaries.base]\nsoil = \"fixed\"",
                                "[boundaries.base]\nsoil = \"viscous\"");
    text = replaced(text, "frequency = 180", "frequency = 180\ncycles = 18");
    text = replaced(text, "end_time = 0.2", "end_time = \"10 min\"");
    EXPECT_EQ(
        SceneFolder().assembly_message(text, column_section()),
        R"(scene.toml:30:1: warning[long-absorption]: the curve "base" lets waves out, and the run goes on for 599.9 s after the shaking: dashpots bear no force for long, the soil creeps away
   30 | [boundaries.base]
      | ^~~~~~~~~~~~~~~~~
expected: a stage of kind = "consolidate" for what follows the shaking: it holds the curve
to accept it: accept = ["boundaries.base"] at the top of the scene
)");
}

TEST(Assembly, NamesARegionTooThinForAnyParticle)
{
    Section section = column_section();
    Region seal = section.regions[0];
    seal.name = "film";
    for (Vector2& corner : seal.polygons[0].outer) corner.y() = corner.y() > 0.1 ? 0.317500002 : 0.3175;
    section.regions.push_back(seal);
    const std::string text =
        replaced(column_scene, "[regions.sand]", "[regions.film]\nmaterial = \"sand\"\n[regions.sand]");
    const std::string message = SceneFolder().assembly_message(text, section);
    EXPECT_NE(message.find("error[sampling]: the region \"film\" ("), std::string::npos) << message;
    EXPECT_NE(message.find("got no particle: it is thinner than a millionth of one"), std::string::npos)
        << message;
}

TEST(Assembly, NamesAProbeOutsideTheSoil)
{
    const std::string probes = "[probes.stray]\nkind = \"material\"\nat = [5.0, 5.0]\n"
                               "[probes.beside]\nkind = \"surface\"\nat = [5.0, 0.0]\n"
                               "[probes.above]\nkind = \"fixed\"\nat = [0.03, 0.4]\n";
    const std::string message =
        SceneFolder().assembly_message(column_scene + ("\n" + probes), column_section());
    EXPECT_NE(
        message.find("error[probe]: the probe \"stray\" at (5, 5) m lies outside the soil: the nearest"),
        std::string::npos)
        << message;
    for (const char* name : {"beside", "above"}) {
        const std::string warning = std::string("warning[probe]: the probe \"") + name +
                                    "\" begins outside the soil: its rows stay empty until soil gets there";
        EXPECT_NE(message.find(warning), std::string::npos) << message;
    }
}

TEST(Assembly, KeepsQuietOfAnAcceptedProbeWithoutSoil)
{
    const std::string text = replaced(column_scene, "title = \"column\"", "accept = [\"probes.above\"]") +
                             "\n[probes.above]\nkind = \"fixed\"\nat = [0.03, 0.4]\n";
    EXPECT_EQ(SceneFolder().assembly_message(text, column_section()), "");
}

TEST(Assembly, KeepsQuietOfWhatIsAccepted)
{
    std::string text = replaced(column_scene, "\"7.5 mm\"", "\"7.5 mm\"\norigin = [0, -0.005]");
    text = replaced(text, "title = \"column\"", "accept = [\"boundaries.base\"]");
    EXPECT_EQ(SceneFolder().assembly_message(text, column_section()), "");
}

TEST(Assembly, RefusesAGridOfTooManyCells)
{
    const std::string text = replaced(column_scene, "\"7.5 mm\"", "1e-6");
    const std::string message = SceneFolder().assembly_message(text, column_section());
    EXPECT_NE(message.find("error[range]: the grid has 67500 x 3.65125e5 cells"), std::string::npos)
        << message;
}

TEST(Assembly, WarnsOfSoilThatNoCurveBears)
{
    const std::string text = replaced(column_scene, "soil = \"fixed\"", "soil = \"free\"");
    const std::string message = SceneFolder().assembly_message(text, column_section());
    EXPECT_NE(message.find("warning[support]: no curve bears the soil: it falls under its weight"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("expected: soil = \"fixed\" or \"roller\" on a curve"), std::string::npos)
        << message;
}

// Upright rollers bear no weight.
TEST(Assembly, WarnsOfSoilThatOnlyUprightRollersTouch)
{
    std::string text = replaced(column_scene, "soil = \"fixed\"", "soil = \"free\"");
    text = replaced(text, "soil = \"tied\"\ntied_to = \"right\"", "soil = \"roller\"");
    text = replaced(text, "soil = \"tied\"\ntied_to = \"left\"", "soil = \"roller\"");
    EXPECT_NE(SceneFolder().assembly_message(text, column_section()).find("warning[support]"),
              std::string::npos);
    const std::string borne =
        replaced(text, "soil = \"free\"\n\n[boundaries.left]", "soil = \"roller\"\n\n[boundaries.left]");
    EXPECT_EQ(SceneFolder().assembly_message(borne, column_section()).find("warning[support]"),
              std::string::npos);
}

TEST(Assembly, WarnsOfDampingThatTheShakingIsNotIn)
{
    const std::string text =
        replaced(column_scene, "poisson_ratio = 0.3", "poisson_ratio = 0.3\ndamping_ratio = 0.02");
    const std::string message = SceneFolder().assembly_message(text, column_section());
    EXPECT_NE(
        message.find("warning[damping]: materials.sand.damping_ratio holds from 0.474 to 19 Hz, and the "
                     "shaking has up to 180 Hz"),
        std::string::npos)
        << message;
    EXPECT_NE(message.find("hint: damping_frequency is the middle of the band: take that of the shaking"),
              std::string::npos)
        << message;
    const std::string suited =
        replaced(text, "damping_ratio = 0.02", "damping_ratio = 0.02\ndamping_frequency = 180");
    EXPECT_EQ(SceneFolder().assembly_message(suited, column_section()), "");
}

TEST(Assembly, RefusesMorePointsThanTheMachineCanHold)
{
    const std::string text = replaced(column_scene, "\"7.5 mm\"", "1.5e-5");
    const std::string message = SceneFolder().assembly_message(text, column_section());
    EXPECT_NE(message.find("error[range]: some "), std::string::npos) << message;
    EXPECT_NE(message.find(" material points need "), std::string::npos) << message;
    EXPECT_NE(message.find("hint: a larger cell_size or fewer particles_per_cell"), std::string::npos)
        << message;
}

TEST(Assembly, RefusesCellsLargerThanTheSection)
{
    const std::string text = replaced(column_scene, "\"7.5 mm\"", "0.5");
    const std::string message = SceneFolder().assembly_message(text, column_section());
    EXPECT_NE(message.find("is smaller than a cell of 0.5 m\n"), std::string::npos) << message;
    EXPECT_NE(message.find("hint: give a smaller grid.cell_size"), std::string::npos) << message;
}

} // namespace
} // namespace quicksand
