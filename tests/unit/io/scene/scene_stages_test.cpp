// Scenes with stages: one reading for each, with what is common and what the stage changes.
#include "io/scene/stage_changes.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/faces/free_face.hpp"
#include "solver/faces/moving_wall.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::SceneFolder;

const std::string settle = "[[stages]]\nkind = \"settle\"\n";
const std::string shake = "[[stages]]\nname = \"shaking\"\nkind = \"shake\"\nduration = \"50 ms\"\n";
const std::string consolidate = "[[stages]]\nkind = \"consolidate\"\nduration = \"2 h\"\n";

std::vector<SceneReading> read_stages(const std::string& text, const std::vector<std::string>& overrides = {})
{
    const SceneFolder folder;
    folder.write("scene.toml", text);
    return read_scene_stages(folder.file("scene.toml"), overrides);
}

TEST(SceneStages, ASceneWithoutStagesIsTheOnlyOne)
{
    const auto stages = read_stages(column_scene);
    ASSERT_EQ(stages.size(), 1U);
    EXPECT_FALSE(stages[0].scene.stage);
}

TEST(SceneStages, EachKindHasWhatItNeeds)
{
    const auto stages = read_stages(column_scene + settle + shake + consolidate);
    ASSERT_EQ(stages.size(), 3U);
    const Scene &rest = stages[0].scene, &shaken = stages[1].scene, &drained = stages[2].scene;
    EXPECT_EQ(rest.stage->name, "settle");
    EXPECT_TRUE(rest.relaxation);
    EXPECT_TRUE(std::holds_alternative<NoMotion>(rest.base_motion));
    EXPECT_EQ(shaken.stage->name, "shaking");
    EXPECT_FALSE(shaken.relaxation);
    EXPECT_DOUBLE_EQ(shaken.end_time, 0.05);
    EXPECT_TRUE(std::holds_alternative<SineMotion>(shaken.base_motion));
    EXPECT_TRUE(shaken.stage->zero_pressures);
    EXPECT_DOUBLE_EQ(drained.end_time, 7200.0);
    EXPECT_EQ(drained.scheme, TimeScheme::implicit);
    EXPECT_DOUBLE_EQ(drained.output.frame_interval, 7200.0 / 50.0);
    EXPECT_FALSE(drained.stage->zero_pressures);
}

TEST(SceneStages, AStageChangesWhatItsTablesSay)
{
    const auto stages = read_stages(
        column_scene + settle + shake + "[stages.materials.sand]\nhydraulic_conductivity = 1e-3\n" +
        consolidate +
        "[stages.analysis]\nscheme = \"semi_implicit\"\n[stages.boundaries.base]\nsoil = \"roller\"\n");
    const auto conductivity = [](const SceneReading& reading) {
        return reading.scene.materials[0].material.hydraulic_conductivity;
    };
    EXPECT_NE(conductivity(stages[0]), 1e-3);
    EXPECT_EQ(conductivity(stages[1]), 1e-3);
    EXPECT_EQ(conductivity(stages[2]), 1e-3); // from the stage on
    EXPECT_EQ(stages[2].scene.scheme, TimeScheme::semi_implicit);
}

TEST(SceneStages, DampingIsThatOfStagesThatShake)
{
    const auto stages = read_stages(
        fixtures::replaced(column_scene, "poisson_ratio = 0.3", "poisson_ratio = 0.3\ndamping_ratio = 0.02") +
        settle + shake + consolidate);
    const auto is_damped = [](const SceneReading& reading) {
        return vibration_damping_of(reading.scene.materials[0].material.law).has_value();
    };
    EXPECT_FALSE(is_damped(stages[0]));
    EXPECT_TRUE(is_damped(stages[1]));
    EXPECT_FALSE(is_damped(stages[2]));
}

// One column of cells cannot go on as all of them.
TEST(SceneStages, AllColumnsAreComputedWhereAnyStageMovesACurveOrUntiesASide)
{
    const std::string moving = "[stages.boundaries.surface]\nsoil = \"moving\"\nvelocity = [0.01, 0.0]\n";
    const std::string untied =
        "[stages.boundaries.left]\nsoil = \"roller\"\n[stages.boundaries.right]\nsoil = \"roller\"\n";
    for (const std::string& change : {moving, untied})
        for (const SceneReading& stage : read_stages(column_scene + settle + shake + change))
            EXPECT_EQ(stage.scene.columns, ColumnsComputed::all) << stage.scene.stage->name << change;
    const std::string stopped = fixtures::replaced(column_scene, "soil = \"free\"",
                                                   "soil = \"moving\"\nvelocity = [0.01, 0.0]"),
                      tied = "soil = \"tied\"\ntied_to = \"right\"",
                      other_tied = "soil = \"tied\"\ntied_to = \"left\"",
                      rollers =
                          fixtures::replaced(fixtures::replaced(column_scene, tied, "soil = \"roller\""),
                                             other_tied, "soil = \"roller\"");
    for (const std::string& scene :
         {stopped + settle + shake + "[stages.boundaries.surface]\nsoil = \"free\"\n",
          rollers + settle + shake + "[stages.boundaries.left]\n" + tied + "\n[stages.boundaries.right]\n" +
              other_tied + "\n"})
        for (const SceneReading& stage : read_stages(scene))
            EXPECT_EQ(stage.scene.columns, ColumnsComputed::all) << stage.scene.stage->name << scene;
    for (const SceneReading& stage : read_stages(column_scene + settle + shake))
        EXPECT_EQ(stage.scene.columns, ColumnsComputed::one) << stage.scene.stage->name;
}

TEST(SceneStages, SoilIsAnotherOneByTheKeysOfItsSkeletonAlone)
{
    const auto stages = read_stages(column_scene + settle + shake +
                                    "[stages.materials.sand]\nhydraulic_conductivity = 1e-3\n" + consolidate +
                                    "[stages.materials.sand]\nporosity = 0.41\n");
    EXPECT_EQ(changed_soils(stages[0].keys, stages[1].keys, {"sand"}), std::vector<bool>{false});
    EXPECT_EQ(changed_soils(stages[1].keys, stages[2].keys, {"sand"}), std::vector<bool>{true});
    EXPECT_EQ(changed_soils(stages[2].keys, stages[2].keys, {"sand"}), std::vector<bool>{false});
}

// What liquefied sand does after the shaking follows from strains of the shaking.
TEST(SceneStages, SandRemembersFromTheStartWhatALaterStageAsksFor)
{
    const auto keeps = [](const SceneReading& reading) {
        return keeps_history(reading.scene.materials[0].material.law);
    };
    const std::string elastic =
        "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3\n";
    std::string sand = column_scene;
    sand.replace(sand.find(elastic), elastic.size(), "model = \"ubcsand\"\nrelative_density = 0.6\n");
    for (const std::string key : {"reconsolidation_slope = 0.3", "liquefied_conductivity = 5.0"}) {
        const auto stages =
            read_stages(sand + settle + shake + consolidate + "[stages.materials.sand]\n" + key + "\n");
        EXPECT_EQ(changed_soils(stages[1].keys, stages[2].keys, {"sand"}), std::vector<bool>{false});
        for (const SceneReading& stage : stages) EXPECT_TRUE(keeps(stage)) << key;
    }
    EXPECT_FALSE(keeps(read_stages(sand + settle + shake).front()));
}

TEST(SceneStages, ANewKindOfBoundaryDropsTheKeysOfTheOldOne)
{
    const auto stages = read_stages(
        column_scene + settle +
        "[stages.boundaries.left]\nsoil = \"roller\"\n[stages.boundaries.right]\nsoil = \"roller\"\n" +
        shake);
    const auto left = [](const SceneReading& reading) {
        return find_boundary(reading.scene, "left")->boundary.soil;
    };
    EXPECT_TRUE(std::holds_alternative<RollerWall>(left(stages[0])));
    EXPECT_TRUE(std::holds_alternative<RollerWall>(left(stages[1])));
}

TEST(SceneStages, SeepageIsSettlingInTheSteadyFlow)
{
    const auto stages = read_stages(column_scene + settle + "[[stages]]\nkind = \"seepage\"\n" + shake);
    EXPECT_FALSE(stages[0].scene.starts_seeping);
    EXPECT_TRUE(stages[1].scene.starts_seeping);
    EXPECT_TRUE(stages[1].scene.relaxation);
    EXPECT_TRUE(stages[2].scene.starts_seeping); // the water stays
}

TEST(SceneStages, ShareTheLinesOfStillWaterOfAllOfThem)
{
    const auto stages = read_stages(
        column_scene + settle + "[stages.water]\nlevel = 0.2\n" +
        "[[stages]]\nname = \"higher\"\nkind = \"settle\"\n[stages.water]\nlevel = 0.25\n" + shake);
    ASSERT_EQ(stages.size(), 3U);
    for (const SceneReading& stage : stages) {
        ASSERT_EQ(stage.water_lines.size(), 2U);
        EXPECT_EQ(stage.water_lines[0].points.front().y(), 0.2);
        EXPECT_EQ(stage.water_lines[1].points.front().y(), 0.25);
    }
}

TEST(SceneStages, OverridesAndVariantsNameThem)
{
    EXPECT_DOUBLE_EQ(
        read_stages(column_scene + settle + shake, {"stages.shaking.duration=0.1"})[1].scene.end_time, 0.1);
    const SceneFolder folder;
    folder.write("column.toml", column_scene + settle + shake);
    folder.write(
        "variant.toml",
        "scene_version = 1\nbase = \"column.toml\"\n[[stages]]\nname = \"shaking\"\nduration = \"20 ms\"\n" +
            consolidate);
    const auto stages = read_scene_stages(folder.file("variant.toml"), {});
    ASSERT_EQ(stages.size(), 3U);
    EXPECT_DOUBLE_EQ(stages[1].scene.end_time, 0.02);
    EXPECT_EQ(stages[2].scene.stage->name, "consolidate");
}

TEST(SceneStages, TheTextOfAStageReadsAsTheSameStage)
{
    const auto stages = read_stages(column_scene + settle + shake);
    for (const SceneReading& stage : stages) {
        const auto again = read_stages(stage.scene.text);
        ASSERT_EQ(again.size(), 1U);
        EXPECT_EQ(again[0].scene.text, stage.scene.text);
        EXPECT_TRUE(changed_keys(stage.keys, again[0].keys).empty());
    }
}

// A stage's own text has other lines than the file that the place of a finding counts in.
TEST(SceneStages, ExcerptsAreThoseOfTheFile)
{
    const std::string comment = "# of two\n\n# lines\n";
    for (SceneReading& stage : read_stages(comment + column_scene + settle + shake + consolidate)) {
        const SceneBoundary& boundary = stage.scene.boundaries.front();
        stage.warnings.add(error_at(boundary.place, "any", "something is wrong"));
        const std::string message = stage.warnings.render(stage.scene.text);
        EXPECT_NE(message.find("| [boundaries." + boundary.boundary.name + "]"), std::string::npos)
            << message;
    }
}

/// What loads the surface at the beginning and the end of each stage, over the pressure of its scene.
std::vector<std::pair<double, double>> factors_of_surface(const std::vector<SceneReading>& stages)
{
    std::vector<std::pair<double, double>> factors;
    for (const SceneReading& stage : stages) {
        const auto& face = std::get<FreeFace>(find_boundary(stage.scene, "surface")->boundary.soil);
        const bool takes = takes_time(stage.scene.stage->kind);
        factors.emplace_back(history_value(face.load->history, 0.0),
                             history_value(face.load->history, takes ? stage.scene.end_time : 0.0));
    }
    return factors;
}

std::string loaded(const std::string& keys)
{
    return fixtures::replaced(column_scene, "soil = \"free\"\n", "soil = \"free\"\npressure = 1000\n" + keys);
}

using Factors = std::vector<std::pair<double, double>>;

TEST(SceneStages, ALoadGoesOnWhereTheStageBeforeLeftIt)
{
    const std::string stability = "[[stages]]\nkind = \"stability\"\n";
    const std::string ground =
        fixtures::replaced(loaded("ramp_time = \"4 h\"\n"), "model = \"linear_elastic\"",
                           "model = \"mohr_coulomb\"\ncohesion = 1000\nfriction_angle = 30");
    EXPECT_EQ(factors_of_surface(read_stages(ground + settle + consolidate + stability + consolidate +
                                             "name = \"on\"\n" + stability + "name = \"end\"\n")),
              (Factors{{0.0, 0.0}, {0.0, 0.5}, {0.5, 0.5}, {0.5, 1.0}, {1.0, 1.0}}));
}

TEST(SceneStages, AnOscillatingLoadGoesOnInItsPhase)
{
    const Factors factors = factors_of_surface(
        read_stages(loaded("frequency = 5\n") + settle + shake + consolidate + "name = \"on\"\n"));
    EXPECT_NEAR(factors[1].second, 1.0, 1e-12); // a quarter of a period in 50 ms
    EXPECT_NEAR(factors[2].first, 1.0, 1e-12);
}

TEST(SceneStages, AChangedLoadRisesFromWhatActed)
{
    const std::string change = "[stages.boundaries.surface]\npressure = 4000\n";
    EXPECT_EQ(factors_of_surface(read_stages(loaded("ramp_time = \"1 h\"\n") + settle + consolidate +
                                             consolidate + "name = \"more\"\n" + change)),
              (Factors{{0.0, 0.0}, {0.0, 1.0}, {0.25, 1.0}}));
}

TEST(SceneStages, AWallThatHasMovedMovesOn)
{
    const std::string walls =
        fixtures::replaced(column_scene, "soil = \"free\"\n",
                           "soil = \"moving\"\nnormal_displacement = \"1 mm\"\nramp_time = \"3 h\"\n");
    const auto stages = read_stages(walls + settle + consolidate + consolidate + "name = \"on\"\n");
    const auto moved = [](const SceneReading& stage) {
        const auto& wall = std::get<MovingWall>(find_boundary(stage.scene, "surface")->boundary.soil);
        return displacement_of(wall, {{1.0, 0.0}, {0.0, 0.0}}, stage.scene.end_time).norm();
    };
    EXPECT_NEAR(moved(stages[1]), 1e-3 * 2.0 / 3.0, 1e-15);
    EXPECT_NEAR(moved(stages[2]), 1e-3 / 3.0, 1e-15);
}

} // namespace
} // namespace quicksand
