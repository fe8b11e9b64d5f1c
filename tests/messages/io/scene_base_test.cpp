// Scenes that name a base: what they make together, and what is said of mistakes in either.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

constexpr const char* head = "scene_version = 1\nbase = \"column.toml\"\n";

/// A folder with the sound scene as column.toml.
class Variant : public testing::Test {
protected:
    Variant() { folder.write("column.toml", fixtures::column_scene); }
    fixtures::SceneFolder folder;
};

TEST_F(Variant, ReplacesTheKeysItGives)
{
    const SceneReading reading =
        folder.read(std::string(head) + "title = \"half\"\n[motion]\namplitude = \"12 g\"\n"
                                        "[probes.middle]\nat = [0.03, 0.15]\n",
                    {"run.end_time=0.1"});
    const Scene& scene = reading.scene;
    EXPECT_EQ(scene.title, "half");
    EXPECT_DOUBLE_EQ(std::get<SineMotion>(scene.base_motion).amplitude, 12.0 * standard_gravity);
    EXPECT_DOUBLE_EQ(std::get<SineMotion>(scene.base_motion).frequency, 180.0);
    EXPECT_DOUBLE_EQ(scene.end_time, 0.1);
    EXPECT_EQ(scene.probes.size(), 2U);
}

TEST_F(Variant, GoesWithoutKeysOfItsBase)
{
    const std::string dry =
        std::string(head) + "without = [\"water\", \"materials.sand.hydraulic_conductivity\"]\n";
    const SceneReading reading = folder.read(dry);
    EXPECT_FALSE(reading.scene.water);
    EXPECT_EQ(folder.read(reading.scene.text).scene.text, reading.scene.text);
    EXPECT_EQ(reading.scene.text.find("without"), std::string::npos);
}

TEST_F(Variant, GoesWithoutNothingElse)
{
    EXPECT_EQ(folder.message(std::string(head) + "without = [\"watr\"]\n"),
              R"_(scene.toml:3:12: error[without]: the base has no 'watr'
    3 | without = ["watr"]
      |            ^~~~~~
expected: a key or table of column.toml, as "water" or "motion.cycles"
)_");
    EXPECT_EQ(folder.message(fixtures::replaced(fixtures::column_scene, "scene_version = 1",
                                                "scene_version = 1\nwithout = [\"water\"]")),
              R"_(scene.toml:2:1: error[without]: the scene has no base to leave keys out of
    2 | without = ["water"]
      | ^~~~~~~
hint: remove the key, or add base = "scene.toml"
)_");
}

TEST_F(Variant, LeavesACopyThatStandsByItself)
{
    const std::string copy =
        folder.read(std::string(head) + "[boundaries.base]\nsoil = \"roller\"\n").scene.text;
    EXPECT_EQ(copy.find("column.toml"), std::string::npos);
    const SceneReading again = folder.read(copy);
    EXPECT_EQ(again.scene.boundaries.size(), 4U);
    EXPECT_TRUE(std::holds_alternative<RollerWall>(again.scene.boundaries.front().boundary.soil));
    EXPECT_DOUBLE_EQ(again.scene.gravity, 120.0 * standard_gravity);
    EXPECT_DOUBLE_EQ(again.scene.end_time, 0.2);
}

TEST_F(Variant, IsReportedWhereTheMistakeIs)
{
    EXPECT_EQ(folder.message(std::string(head) + "[motion]\namplitud = \"12 g\"\n"),
              R"_(scene.toml:4:1: error[unknown-key]: unknown key 'amplitud' in [motion]
    4 | amplitud = "12 g"
      | ^~~~~~~~
expected: one of kind, amplitude, frequency, cycles, ramp_cycles, ramp_down_cycles
hint: did you mean amplitude?
)_");
    folder.write("column.toml",
                 fixtures::replaced(fixtures::column_scene, "poisson_ratio = 0.3", "poisson_ratio = 0.5"));
    EXPECT_EQ(folder.message(head),
              R"_(column.toml:22:17: error[range]: materials.sand.poisson_ratio = 0.5 is out of range
   22 | poisson_ratio = 0.5
      |                 ^~~
expected: at least 0 and less than 0.5
)_");
}

TEST_F(Variant, NeedsABaseBesideIt)
{
    const auto message = [&](const std::string& name) {
        return folder.message("scene_version = 1\nbase = \"" + name + "\"\n");
    };
    EXPECT_EQ(message("../column.toml"),
              R"_(scene.toml:2:8: error[base]: the base is not in the folder of this scene
    2 | base = "../column.toml"
      |        ^~~~~~~~~~~~~~~~
expected: the name of a scene in the same folder
)_");
    EXPECT_EQ(message("scene.toml"), R"_(scene.toml:2:8: error[base]: the scene names itself as its base
    2 | base = "scene.toml"
      |        ^~~~~~~~~~~~
expected: the name of another scene in the same folder
)_");
    EXPECT_EQ(message("missing.toml"), R"_(scene.toml:2:8: error[file]: 'missing.toml' does not exist
    2 | base = "missing.toml"
      |        ^~~~~~~~~~~~~~
hint: the path is relative to the file that names it
)_");
}

TEST_F(Variant, CanBeOfAVariant)
{
    folder.write("second.toml", std::string(head) +
                                    "without = [\"probes\"]\n[motion]\namplitude = \"9 g\"\n" +
                                    "[materials.sand]\nporosity = 0.41\n");
    const SceneReading reading =
        folder.read("scene_version = 1\nbase = \"second.toml\"\n[materials.sand]\nporosity = 0.42\n");
    EXPECT_DOUBLE_EQ(std::get<SineMotion>(reading.scene.base_motion).amplitude, 9.0 * standard_gravity);
    EXPECT_DOUBLE_EQ(reading.scene.materials.front().material.porosity, 0.42);
    EXPECT_TRUE(reading.scene.probes.empty());
    EXPECT_EQ(reading.scene.text.find("base = "), std::string::npos);
}

TEST_F(Variant, DoesNotLeadBackToItself)
{
    folder.write("second.toml", "scene_version = 1\nbase = \"third.toml\"\n");
    folder.write("third.toml", "scene_version = 1\nbase = \"second.toml\"\n");
    EXPECT_EQ(folder.message("scene_version = 1\nbase = \"second.toml\"\n"),
              R"_(third.toml:2:8: error[base]: 'second.toml' has this scene among its bases
    2 | base = "second.toml"
      |        ^~~~~~~~~~~~~
expected: a scene that does not lead back to this one
)_");
}

} // namespace
} // namespace quicksand
