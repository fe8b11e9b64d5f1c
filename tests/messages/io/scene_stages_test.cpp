// Stages of a scene: what is said of mistakes in them.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::column_message;
using fixtures::settle_stage;

const std::string shake = "[[stages]]\nname = \"shaking\"\nkind = \"shake\"\nduration = 1\n";

TEST(SceneStageMessages, StagesHaveNamesOfTheirOwn)
{
    EXPECT_EQ(column_message(settle_stage + settle_stage),
              R"_(scene.toml:57:1: error[stage]: there are two stages 'settle'
   57 | [[stages]]
      | ^~~~~~~~~~
expected: a name for each stage
hint: give one of them a name, as name = "settle_2"
)_");
}

TEST(SceneStageMessages, NamesAreThoseOfFolders)
{
    EXPECT_EQ(column_message("[[stages]]\nname = \"a/b\"\nkind = \"settle\"\n"),
              R"_(scene.toml:56:8: error[stage]: a stage cannot be called 'a/b'
   56 | name = "a/b"
      |        ^~~~~
expected: letters, digits, - and _, other than the names of a run's own folders
hint: its results are a folder of this name
)_");
}

TEST(SceneStageMessages, KindsAreKnown)
{
    EXPECT_EQ(column_message("[[stages]]\nkind = \"setle\"\n"),
              R"_(scene.toml:56:8: error[word]: stages.setle.kind = "setle" is not known
   56 | kind = "setle"
      |        ^~~~~~~
expected: one of settle, seepage, shake, consolidate, stability
hint: did you mean "settle"?
)_");
}

TEST(SceneStageMessages, AKindIsRequired)
{
    EXPECT_EQ(column_message("[[stages]]\nname = \"first\"\n"),
              R"_(scene.toml:55:1: error[missing-key]: [stages.first] has no kind
   55 | [[stages]]
      | ^~~~~~~~~~
expected: kind: Settle under gravity, with still water or in the steady flow between heads; shake; let excess pore pressures go in long steps; find the factor of safety.
)_");
}

TEST(SceneStageMessages, ADurationThatIsNoneIsToldOnce)
{
    for (const char* motion : {"", "[stages.motion]\ncycles = 1e6\n"}) // nor as a run that ends too early
        EXPECT_EQ(
            column_message(std::string("[[stages]]\nkind = \"shake\"\nduration = \"60 weeks\"\n") + motion),
            R"_(scene.toml:57:12: error[unit]: stages.shake.duration has the unit 'weeks'
   57 | duration = "60 weeks"
      |            ^~~~~~~~~~
expected: one of s, ms, us, min, h, day, d
)_");
    EXPECT_EQ(column_message("[[stages]]\nkind = \"shake\"\nduration = -1\n"),
              R"_(scene.toml:57:12: error[range]: stages.shake.duration = -1 s is out of range
   57 | duration = -1
      |            ^~
expected: more than 0 s
)_");
}

TEST(SceneStageMessages, SettlingHasNoDuration)
{
    EXPECT_EQ(column_message(settle_stage + "duration = 4\n"),
              R"_(scene.toml:57:1: error[unused-key]: stages.settle.duration is not used with kind = "settle"
   57 | duration = 4
      | ^~~~~~~~
hint: remove it, or set kind = "shake"
)_");
}

TEST(SceneStageMessages, KeysOfAStageAreKnown)
{
    EXPECT_EQ(column_message(settle_stage + shake + "displacement = \"zero\"\n"),
              R"_(scene.toml:61:1: error[unknown-key]: unknown key 'displacement' in [stages.shaking]
   61 | displacement = "zero"
      | ^~~~~~~~~~~~
expected: one of kind, duration, displacements, excess_pressures
hint: did you mean displacements?
)_");
}

TEST(SceneStageMessages, TablesOfAStageAreThoseOfTheScene)
{
    EXPECT_EQ(column_message(settle_stage + shake + "[stages.watr]\nlevel = 1\n"),
              R"_(scene.toml:61:1: error[unknown-table]: unknown table [watr]
   61 | [stages.watr]
      | ^~~~~~~~~~~~~
expected: one of geometry, grid, sampling, analysis, gravity, water, materials, regions, interfaces, boundaries, initial, relaxation, motion, run, output, probes, stages, figures, verification
hint: did you mean water?
)_");
}

TEST(SceneStageMessages, StillWaterChangesWhereSoilSettles)
{
    EXPECT_EQ(column_message(settle_stage + shake + "[stages.water]\nlevel = 0.2\n"),
              R"_(scene.toml:57:1: error[stage]: the stage "shaking" cannot change water.level
   57 | [[stages]]
      | ^~~~~~~~~~
expected: a drained stage of kind = "settle" or "seepage", whose soil comes to rest with other water
hint: outer water that rises or falls in time is the head of a boundary, with ramp_time or a history
)_");
}

TEST(SceneStageMessages, ParticlesAreTheSameInAllStages)
{
    EXPECT_EQ(column_message(settle_stage + shake + "[stages.grid]\ncell_size = 0.01\n"),
              R"_(scene.toml:57:1: error[stage]: the stage "shaking" cannot change grid.cell_size
   57 | [[stages]]
      | ^~~~~~~~~~
expected: the same value in all stages
hint: give grid.cell_size for the whole scene
)_");
}

TEST(SceneStageMessages, StressGoesOnFromTheStageBefore)
{
    EXPECT_EQ(
        column_message(settle_stage + shake + "[stages.initial]\nk0 = 0.8\n"),
        R"_(scene.toml:57:1: error[stage]: the stage "shaking" cannot change initial.k0: it goes on from the end of the stage before
   57 | [[stages]]
      | ^~~~~~~~~~
expected: the table [initial] of the scene
hint: of placed soil stress comes with its weight
)_");
}

TEST(SceneStageMessages, UndrainedSoilHasWaterThatReacts)
{
    const std::string message = column_message("[[stages]]\nkind = \"settle\"\ndrainage = \"undrained\"\n"
                                               "[stages.water]\nflow = \"drained\"\n");
    EXPECT_NE(
        message.find(
            R"_(scene.toml:55:1: error[stage]: no water reacts in the stage "settle", which settles undrained
   55 | [[stages]]
      | ^~~~~~~~~~
expected: a table [water], with flow = "coupled" or "undrained"
)_"),
        std::string::npos)
        << message;
    EXPECT_EQ(column_message(settle_stage + shake + "drainage = \"undrained\"\n"),
              R"_(scene.toml:61:1: error[unused-key]: stages.shaking.drainage is not used with kind = "shake"
   61 | drainage = "undrained"
      | ^~~~~~~~
hint: remove it, or set kind = "settle"
)_");
}

TEST(SceneStageMessages, StabilityNeedsAStrength)
{
    const std::string of_no_region =
        "[materials.other]\nmodel = \"mohr_coulomb\"\nfriction_angle = 30\nshear_modulus = 1e7\n"
        "poisson_ratio = 0.3\nporosity = 0.4\nhydraulic_conductivity = 1e-4\n";
    for (const std::string& other : {std::string(), of_no_region}) {
        const std::string message =
            column_message(settle_stage + "[[stages]]\nkind = \"stability\"\n" + other);
        EXPECT_NE(
            message.find("error[stage]: no soil has a strength that the stage \"stability\" could reduce\n"),
            std::string::npos)
            << message;
        EXPECT_NE(message.find("expected: a material with model = \"mohr_coulomb\" or \"ubcsand\""),
                  std::string::npos)
            << message;
    }
}

TEST(SceneStageMessages, SandThatHasBeenShakenSettlesAsInLaboratories)
{
    const std::string linear =
        "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3\n";
    const std::string drain = "[[stages]]\nname = \"drain\"\nkind = \"consolidate\"\nduration = 100\n";
    const auto warnings = [&](const std::string& sand, const std::string& rest) {
        const std::string scene = fixtures::replaced(fixtures::column_scene, linear, sand);
        return fixtures::SceneFolder().message(scene + settle_stage + rest);
    };
    const std::string said =
        "the sand \"sand\" settles after liquefaction by a fraction of what "
        "laboratories measure, with a reconsolidation_slope of 0, in the stage \"drain\"";
    const std::string second_drain = "[[stages]]\nname = \"again\"\nkind = \"consolidate\"\nduration = "
                                     "100\n[stages.materials.sand]\nreconsolidation_slope = 0\n";
    for (const std::string model : {"ubcsand", "pm4sand"}) {
        const std::string sand = "model = \"" + model + "\"\nrelative_density = 0.5\n";
        const std::string given = "[stages.materials.sand]\nreconsolidation_slope = 0.3\n";
        EXPECT_NE(warnings(sand, shake + drain).find(said), std::string::npos) << model;
        EXPECT_EQ(warnings(sand, shake + drain + given).find(said), std::string::npos) << model;
        EXPECT_NE(warnings(sand, shake + drain + given + second_drain).find("in the stage \"again\""),
                  std::string::npos)
            << model;
        EXPECT_EQ(warnings(sand, drain).find(said), std::string::npos) << model;
        EXPECT_EQ(warnings(sand + "law = \"calibrated\"\n", shake + drain).find(said), std::string::npos);
        EXPECT_EQ(warnings(sand + "porosity = 1.4\n", shake + drain).find(said), std::string::npos);
    }
}

TEST(SceneStageMessages, ThePostShakingOptionIsForAfterTheShaking)
{
    const std::string linear =
        "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3\n";
    const std::string sand = "model = \"pm4sand\"\nrelative_density = 0.5\n";
    const std::string drain = "[[stages]]\nname = \"drain\"\nkind = \"consolidate\"\nduration = "
                              "100\n[stages.materials.sand]\nreconsolidation = 1\n";
    const auto warnings = [&](const std::string& rest) {
        const std::string scene = fixtures::replaced(fixtures::column_scene, linear, sand);
        return fixtures::SceneFolder().message(scene + settle_stage + rest);
    };
    const std::string again = fixtures::replaced(shake, "shaking", "again");
    EXPECT_EQ(warnings(shake + drain).find("post-shaking option"), std::string::npos);
    EXPECT_NE(warnings(shake + drain + again)
                  .find("the sand \"sand\" is shaken with its post-shaking option, reconsolidation, which "
                        "softens it, in the stage \"again\""),
              std::string::npos);
}

TEST(SceneStageMessages, WaterFlowsWhereSoilConsolidates)
{
    EXPECT_EQ(
        column_message(
            settle_stage +
            "[[stages]]\nkind = \"consolidate\"\nduration = 1000\n[stages.water]\nflow = \"undrained\"\n"),
        R"_(scene.toml:25:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect with water.flow = "undrained"
   25 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: remove it, or set water.flow = "coupled"
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
scene.toml:57:1: error[combination]: scheme = "implicit" does not resist the waves of water that moves with the grains, water.flow = "undrained"
   57 | [[stages]]
      | ^~~~~~~~~~
expected: scheme = "explicit", or water.flow = "coupled" with a low conductivity
scene.toml:57:1: error[stage]: no water flows in the stage "consolidate", which is to consolidate
   57 | [[stages]]
      | ^~~~~~~~~~
expected: water.flow = "coupled" in this stage
)_");
}

} // namespace
} // namespace quicksand
