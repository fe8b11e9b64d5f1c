#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::replaced;
using fixtures::SceneFolder;

const ResolvedKey* find(const SceneReading& reading, const std::string& path)
{
    for (const ResolvedKey& key : reading.keys) {
        if (key.path == path) return &key;
    }
    return nullptr;
}

const std::string sine = "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180";

TEST(SceneFile, ConvertsToSiAndTakesDefaults)
{
    const SceneReading reading = SceneFolder().read(column_scene);
    const Scene& scene = reading.scene;
    EXPECT_EQ(scene.text, column_scene);
    EXPECT_EQ(scene.geometry_file.filename(), "column.geo");
    EXPECT_EQ(scene.cell_size, 0.0075);
    EXPECT_FALSE(scene.grid_origin);
    EXPECT_FALSE(scene.grid_cells);
    EXPECT_EQ(std::get<LatticeSampling>(scene.sampling).per_cell_x, 3);
    EXPECT_EQ(scene.gravity, 120 * 9.81);
    EXPECT_EQ(scene.water->density, 1000.0);
    EXPECT_EQ(scene.water->bulk_modulus, 2.2e9);
    EXPECT_EQ(scene.water->level, 0.3175);
    const Material& sand = scene.materials.at(0).material;
    EXPECT_EQ(sand.name, "sand");
    EXPECT_EQ(std::get<LinearElastic>(sand.law).shear_modulus, 60e6);
    EXPECT_EQ(sand.conductivity_gravity, 9.81);
    EXPECT_EQ(scene.k0, 0.5);
    EXPECT_FALSE(scene.relaxation);
    EXPECT_EQ(scene.output.frame_interval, 0.2 / 50.0);
    EXPECT_EQ(scene.output.probe_interval, 0.2 / 400.0);
    EXPECT_EQ(scene.output.history_interval, 0.2 / 200.0);
    EXPECT_EQ(scene.output.checkpoint_interval, 60.0);
}

TEST(SceneFile, SealsWallsAndDrainsFreeSurfaces)
{
    const SceneFolder folder;
    const Scene scene = folder.read(replaced(column_scene, "soil = \"free\"", "soil = \"roller\"")).scene;
    EXPECT_TRUE(std::holds_alternative<Impervious>(scene.boundaries.at(0).boundary.water));
    EXPECT_TRUE(std::holds_alternative<Impervious>(scene.boundaries.at(3).boundary.water));
    EXPECT_TRUE(
        std::holds_alternative<Drained>(folder.read(column_scene).scene.boundaries.at(3).boundary.water));
    const std::string drained =
        replaced(column_scene, "soil = \"fixed\"", "soil = \"fixed\"\nwater = \"drained\"");
    EXPECT_TRUE(std::holds_alternative<Drained>(folder.read(drained).scene.boundaries.at(0).boundary.water));
}

TEST(SceneFile, ResolvesEveryKeyAndTellsDefaultsFromGivenOnes)
{
    const SceneReading reading = SceneFolder().read(column_scene);
    ASSERT_NE(find(reading, "grid.cell_size"), nullptr);
    EXPECT_TRUE(find(reading, "grid.cell_size")->given);
    EXPECT_EQ(find(reading, "grid.cell_size")->value, "0.0075");
    EXPECT_EQ(find(reading, "grid.cell_size")->unit, "m");
    EXPECT_FALSE(find(reading, "boundaries.base.water")->given);
    EXPECT_EQ(find(reading, "boundaries.base.water")->value, "impervious");
    EXPECT_EQ(find(reading, "output.frame_interval")->value, "0.004");
    EXPECT_EQ(find(reading, "motion.cycles")->value, "without end");
    EXPECT_EQ(find(reading, "grid.cells")->value, "what covers the section, with room above it");
    EXPECT_EQ(find(reading, "relaxation.damping"), nullptr);
    EXPECT_EQ(find(reading, "probes.crest.to"), nullptr);
}

TEST(SceneFile, ReadsADryScene)
{
    std::string text = replaced(column_scene, "[water]\nlevel = 0.3175\n", "");
    text = replaced(text, "hydraulic_conductivity = 5.8e-5\n", "");
    const SceneReading reading = SceneFolder().read(text);
    EXPECT_FALSE(reading.scene.water);
    EXPECT_TRUE(reading.warnings.empty());
    EXPECT_EQ(find(reading, "boundaries.base.water"), nullptr);
}

TEST(SceneFile, ReadsNamesOfAnyKind)
{
    std::string text = replaced(column_scene, "[materials.sand]", "[materials.\"Sand, grün (1.5 m)\"]");
    text = replaced(text, "material = \"sand\"", "material = \"Sand, grün (1.5 m)\"");
    const SceneReading reading = SceneFolder().read(text);
    EXPECT_EQ(reading.scene.materials.at(0).material.name, "Sand, grün (1.5 m)");
    EXPECT_EQ(find(reading, "materials.\"Sand, grün (1.5 m)\".porosity")->value, "0.405");
}

TEST(SceneFile, TakesOverridesAsTomlOrAsBareWords)
{
    const SceneFolder folder;
    const Scene scene =
        folder
            .read(column_scene, {"materials.sand.porosity=0.4", "materials.sand.shear_modulus=50 MPa",
                                 "boundaries.surface.soil = roller", "grid.cells=[9, 60]",
                                 "relaxation.tolerance=1e-5", "title=a = b"})
            .scene;
    EXPECT_EQ(scene.materials.at(0).material.porosity, 0.4);
    EXPECT_EQ(std::get<LinearElastic>(scene.materials.at(0).material.law).shear_modulus, 50e6);
    EXPECT_TRUE(std::holds_alternative<RollerWall>(scene.boundaries.at(3).boundary.soil));
    EXPECT_EQ(scene.grid_cells->second, 60);
    EXPECT_EQ(scene.relaxation->tolerance, 1e-5);
    EXPECT_EQ(scene.relaxation->damping, 0.7);
    EXPECT_EQ(scene.title, "a = b");
}

TEST(SceneFile, TakesNumbersOfOverridesAsTheyAreTyped)
{
    const SceneFolder folder;
    const auto porosity = [&](const std::string& value) {
        return folder.read(column_scene, {"materials.sand.porosity=" + value})
            .scene.materials.at(0)
            .material.porosity;
    };
    EXPECT_EQ(porosity(".4"), 0.4);
    EXPECT_EQ(porosity("00.4"), 0.4);
    EXPECT_EQ(porosity("4.e-1"), 0.4);
    EXPECT_EQ(porosity("+.4"), 0.4);
    for (const char* word : {"007", "infinity", "NaN"})
        EXPECT_EQ(folder.read(column_scene, {std::string("title=") + word}).scene.title, word);
}

TEST(SceneFile, TakesTheLastOfTwoOverrides)
{
    EXPECT_EQ(SceneFolder().read(column_scene, {"run.end_time=1", "run.end_time=\"2 ms\""}).scene.end_time,
              0.002);
}

TEST(SceneFile, ReadsASineWithoutEnd)
{
    const Scene scene = SceneFolder().read(column_scene).scene;
    const auto& motion = std::get<SineMotion>(scene.base_motion);
    EXPECT_EQ(motion.amplitude, 24 * 9.81);
    EXPECT_TRUE(std::isinf(motion.cycles));
    EXPECT_EQ(motion.ramp_cycles, 0.0);
}

TEST(SceneFile, ReadsARecordWithOrWithoutHeader)
{
    const SceneFolder folder;
    const std::string keys = "kind = \"file\"\nfile = \"record.csv\"\nunit = \"g\"\nscale = 2.0";
    const std::string text = replaced(column_scene, sine, keys);
    for (const std::string header : {"", "time_s,acceleration_g\r\n", "# a comment\ntime acceleration\n"}) {
        folder.write("record.csv", header + "0, 0\n0.01, 0.1\n\n0.02; -0.2\n0.03\t0\n");
        const Scene scene = folder.read(text).scene;
        const auto& motion = std::get<SampledMotion>(scene.base_motion);
        EXPECT_NEAR(motion.interval, 0.01, 1e-15);
        ASSERT_EQ(motion.accelerations.size(), 4U);
        EXPECT_DOUBLE_EQ(motion.accelerations[2], -0.2 * 2.0 * 9.81);
    }
}

TEST(SceneFile, WarnsOfShakingThatIsCutOff)
{
    const SceneFolder folder;
    folder.write("record.csv", "0 0\n0.2 1\n0.4 0\n");
    const std::string text =
        replaced(column_scene, sine, "kind = \"file\"\nfile = \"record.csv\"\nunit = \"m/s2\"");
    const std::string message = folder.message(text);
    EXPECT_TRUE(message.ends_with(
        R"(scene.toml:50:12: warning[motion]: the run ends at 0.2 s, the shaking at 0.4 s
   50 | end_time = 0.2
      |            ^~~
to accept it: accept = ["run.end_time"] at the top of the scene
)")) << message;
}

TEST(SceneFile, ReadsMeshSamplingAndParameters)
{
    std::string text = replaced(column_scene, "particles_per_cell = [3, 3]", "kind = \"mesh\"");
    text = replaced(text, "file = \"column.geo\"",
                    "file = \"column.geo\"\nparameters = { height = 0.25, n = 3 }");
    const Scene scene = SceneFolder().read(text).scene;
    EXPECT_EQ(std::get<MeshSampling>(scene.sampling).quad_size, 0.0075 / 3.0);
    EXPECT_EQ(scene.geometry_parameters, (std::map<std::string, double>{{"height", 0.25}, {"n", 3.0}}));
}

} // namespace
} // namespace quicksand
