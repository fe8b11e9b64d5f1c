// Interfaces between regions that do not touch, have no strength or are given twice.
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/scene_mistake.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using fixtures::SceneFolder;

const std::string slab_scene = R"(scene_version = 1
[geometry]
file = "column.geo"
[grid]
cell_size = 0.25
[materials.sand]
model = "mohr_coulomb"
shear_modulus = "8 MPa"
poisson_ratio = 0.3
friction_angle = 35.0
porosity = 0.4
[materials.concrete]
model = "linear_elastic"
water = "none"
density = 2400
shear_modulus = "1 GPa"
poisson_ratio = 0.2
[regions.sand]
material = "sand"
[regions.wall]
material = "concrete"
[regions.slab]
material = "concrete"
[interfaces.face]
regions = ["wall", "sand"]
friction_angle = 20
[boundaries.base]
soil = "fixed"
[run]
end_time = 1.0
)";

/// Sand with a wall on its right, on which a slab lies.
Section section()
{
    Section drawn = fixtures::polygon_section(
        {{{0.0, 0.0}, "base"}, {{4.0, 0.0}, ""}, {{4.0, 2.0}, ""}, {{0.0, 2.0}, ""}});
    drawn.regions[0].name = "sand";
    drawn.regions.push_back({"wall", {{{{4.0, 0.0}, {5.0, 0.0}, {5.0, 2.0}, {4.0, 2.0}}, {}}}});
    drawn.regions.push_back({"slab", {{{{4.5, 2.0}, {5.0, 2.0}, {5.0, 2.5}, {4.5, 2.5}}, {}}}});
    bound_section(drawn);
    return drawn;
}

using fixtures::SceneMistake;

class Interfaces : public testing::TestWithParam<SceneMistake> {};

TEST_P(Interfaces, AreJudgedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const std::string text = fixtures::replaced(slab_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(SceneFolder().assembly_message(text, section()), mistake.message.substr(1));
}

TEST(SoundInterface, IsNotCommented)
{
    EXPECT_EQ(SceneFolder().assembly_message(slab_scene, section()), "");
}

TEST(SoundInterface, WaitsForSoilThatAStagePlaces)
{
    const std::string waits =
        fixtures::replaced(slab_scene, "[regions.wall]\n", "[regions.wall]\nsoil = \"absent\"\n");
    EXPECT_EQ(SceneFolder().assembly_message(waits, section()), "");
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, Interfaces, testing::Values(
SceneMistake{"OfOneRegion", "[\"wall\", \"sand\"]", "[\"wall\"]",
R"_(
scene.toml:25:11: error[interface]: interfaces.face.regions names 1 of the two that touch
   25 | regions = ["wall"]
      |           ^~~~~~~~
expected: two regions, as ["caisson", "sand"]
)_"},
SceneMistake{"OfOneRegionTwice", "[\"wall\", \"sand\"]", "[\"wall\", \"wall\"]",
R"_(
scene.toml:25:11: error[interface]: interfaces.face.regions names the same region twice
   25 | regions = ["wall", "wall"]
      |           ^~~~~~~~~~~~~~~~
expected: two regions, as ["caisson", "sand"]
)_"},
SceneMistake{"OfNoRegion", "[\"wall\", \"sand\"]", "[\"wall\", \"snad\"]",
R"_(
scene.toml:25:11: error[interface]: there is no region "snad"
   25 | regions = ["wall", "snad"]
      |           ^~~~~~~~~~~~~~~~
expected: one of sand, wall, slab
hint: did you mean "sand"?
)_"},
SceneMistake{"OfRegionsThatDoNotTouch", "[\"wall\", \"sand\"]", "[\"slab\", \"sand\"]",
R"_(
scene.toml:25:11: error[interface]: the regions "slab" and "sand" do not touch
   25 | regions = ["slab", "sand"]
      |           ^~~~~~~~~~~~~~~~
expected: two regions of the drawing with a common edge
hint: "slab" touches wall
)_"},
SceneMistake{"OfElasticRegions", "[\"wall\", \"sand\"]", "[\"slab\", \"wall\"]",
R"_(
scene.toml:25:11: error[interface]: neither "slab" nor "wall" has a strength that the interface could lower
   25 | regions = ["slab", "wall"]
      |           ^~~~~~~~~~~~~~~~
expected: a soil with model = one of "mohr_coulomb", "ubcsand", "pm4sand" on one side
hint: elastic soil slides nowhere: give the one that is to slide a strength
)_"},
SceneMistake{"WithoutStrength", "friction_angle = 20", "",
R"_(
scene.toml:24:1: error[missing-key]: [interfaces.face] has no strength
   24 | [interfaces.face]
      | ^~~~~~~~~~~~~~~~~
expected: strength_ratio, or friction_angle with cohesion
hint: steel and concrete on soil: strength_ratio = 0.67 in practice
)_"},
SceneMistake{"WithStrengthOfZero", "friction_angle = 20", "friction_angle = 0",
R"_(
scene.toml:26:18: warning[plausibility]: interfaces.face.friction_angle = 0 deg is unusually small
   26 | friction_angle = 0
      |                  ^
expected: usually 5 to 40 deg
to accept it: accept = ["interfaces.face.friction_angle"] at the top of the scene
scene.toml:26:18: error[range]: [interfaces.face] has no strength: cohesion and friction_angle are both 0
   26 | friction_angle = 0
      |                  ^
expected: one of them more than 0
hint: a smooth face is friction_angle = "1 deg"
)_"},
SceneMistake{"WithTwoStrengths", "friction_angle = 20", "friction_angle = 20\nstrength_ratio = 0.5",
R"_(
scene.toml:26:18: error[conflict]: interfaces.face.friction_angle is given, and strength_ratio reduces that of the soil
   26 | friction_angle = 20
      |                  ^~
expected: strength_ratio alone, or friction_angle with cohesion
hint: remove one of the two
)_"},
SceneMistake{"StrongerThanTheSoil", "friction_angle = 20", "friction_angle = 33",
R"_(
scene.toml:26:18: warning[interface]: interfaces.face.friction_angle is more than the soil beside it bears along a plane: the soil slides itself
   26 | friction_angle = 33
      |                  ^~
expected: less than 29.8 deg for the face to be the weaker one
hint: GUIDE, "Structures", says what soil bears along a plane
to accept it: accept = ["interfaces.face.friction_angle"] at the top of the scene
)_"},
SceneMistake{"ThinnerThanACell", "friction_angle = 20", "friction_angle = 20\nthickness = 0.1",
R"_(
scene.toml:27:13: warning[interface]: interfaces.face.thickness = 0.1 m is less than the grid needs: the face slides with a part of the soil's own strength
   27 | thickness = 0.1
      |             ^~~
expected: at least 0.25 m
hint: remove it, or choose smaller cells
to accept it: accept = ["interfaces.face.thickness"] at the top of the scene
)_"},
SceneMistake{"ThinnerThanAParticle", "friction_angle = 20", "friction_angle = 20\nthickness = 0.01",
R"_(
scene.toml:24:1: error[interface]: no particle lies within 0.01 m of the interface "face"
   24 | [interfaces.face]
      | ^~~~~~~~~~~~~~~~~
hint: a larger thickness, smaller cells or more particles_per_cell
scene.toml:27:13: warning[interface]: interfaces.face.thickness = 0.01 m is less than the grid needs: the face slides with a part of the soil's own strength
   27 | thickness = 0.01
      |             ^~~~
expected: at least 0.25 m
hint: remove it, or choose smaller cells
to accept it: accept = ["interfaces.face.thickness"] at the top of the scene
)_"},
SceneMistake{"GivenTwice", "[boundaries.base]", "[interfaces.other]\nregions = [\"sand\", \"wall\"]\nstrength_ratio = 0.5\n[boundaries.base]",
R"_(
scene.toml:28:11: error[conflict]: "other" has the regions of the interface "face"
   28 | regions = ["sand", "wall"]
      |           ^~~~~~~~~~~~~~~~
expected: one interface for each pair of regions
)_"}), fixtures::name_of);
// clang-format on

TEST(InterfaceOfSand, NeedsFriction)
{
    std::string text = fixtures::replaced(
        slab_scene,
        "model = \"mohr_coulomb\"\nshear_modulus = \"8 MPa\"\npoisson_ratio = 0.3\nfriction_angle = 35.0\n",
        "model = \"ubcsand\"\nrelative_density = 0.5\n");
    text = fixtures::replaced(text, "friction_angle = 20", "friction_angle = 0\ncohesion = \"1 kPa\"");
    EXPECT_EQ(
        SceneFolder().assembly_message("accept = [\"interfaces.face.friction_angle\"]\n" + text, section()),
        R"(scene.toml:25:18: error[interface]: interfaces.face.friction_angle = 0 leaves "sand" no strength: sand has that of friction alone
   25 | friction_angle = 0
      |                  ^
expected: friction_angle above 0
)");
}

/// A variant of the scene, and what it is read as.
class InterfaceOfVariant : public testing::Test {
protected:
    InterfaceOfVariant() { folder.write("wall.toml", slab_scene); }
    static std::string variant(const std::string& keys)
    {
        return "scene_version = 1\nbase = \"wall.toml\"\n" + keys;
    }
    SceneInterface read(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        return folder.read(text, overrides).scene.interfaces.at(0);
    }
    /// The interfaces of all stages that follow the scene.
    std::vector<SceneInterface> read_stages(const std::string& stages,
                                            const std::vector<std::string>& overrides = {}) const
    {
        folder.write("scene.toml", fixtures::replaced(slab_scene, "[run]\nend_time = 1.0\n", "") + stages);
        std::vector<SceneInterface> interfaces;
        for (const SceneReading& reading : read_scene_stages(folder.file("scene.toml"), overrides))
            interfaces.push_back(reading.scene.interfaces.at(0));
        return interfaces;
    }

    const double tan_of_20 = std::tan(20.0 * std::numbers::pi / 180.0);
    SceneFolder folder;
};

TEST_F(InterfaceOfVariant, MayHaveAnotherStrength)
{
    const SceneInterface rougher = read(variant("[interfaces.face]\ncohesion = 1000\n"));
    EXPECT_DOUBLE_EQ(rougher.strength.friction, tan_of_20);
    EXPECT_DOUBLE_EQ(rougher.strength.cohesion, 1000.0);
    const SceneInterface share = read(variant("[interfaces.face]\nstrength_ratio = 0.5\n"));
    EXPECT_DOUBLE_EQ(share.strength_ratio.value_or(0.0), 0.5);
    folder.write("wall.toml", fixtures::replaced(slab_scene, "friction_angle = 20", "strength_ratio = 0.5"));
    const SceneInterface friction = read(variant("[interfaces.face]\nfriction_angle = 20\n"));
    EXPECT_FALSE(friction.strength_ratio);
    EXPECT_DOUBLE_EQ(friction.strength.friction, tan_of_20);
}

TEST_F(InterfaceOfVariant, MayBeLeftOut)
{
    EXPECT_TRUE(folder.read(variant("without = [\"interfaces.face\"]\n")).scene.interfaces.empty());
    EXPECT_TRUE(folder.read(variant("without = [\"interfaces\"]\n")).scene.interfaces.empty());
    EXPECT_EQ(folder.message(variant("without = [\"interfaces.fase\"]\n")),
              R"_(scene.toml:3:12: error[without]: the base has no 'interfaces.fase'
    3 | without = ["interfaces.fase"]
      |            ^~~~~~~~~~~~~~~~~
expected: a key or table of wall.toml, as "water" or "motion.cycles"
)_");
}

TEST_F(InterfaceOfVariant, NeedsItsRegions)
{
    EXPECT_EQ(folder.message(variant("without = [\"regions.wall\"]\n")),
              R"_(wall.toml:25:11: error[interface]: there is no region "wall"
   25 | regions = ["wall", "sand"]
      |           ^~~~~~~~~~~~~~~~
expected: one of sand, slab
hint: an interface goes with its regions: remove it as well, in a variant by without = ["interfaces.face"]
)_");
    EXPECT_EQ(folder.message(variant("without = [\"regions.wall\", \"interfaces.face\"]\n")), "");
}

TEST_F(InterfaceOfVariant, IsSetOnTheCommandLine)
{
    EXPECT_DOUBLE_EQ(read(slab_scene, {"interfaces.face.friction_angle=\"10 deg\""}).strength.friction,
                     std::tan(10.0 * std::numbers::pi / 180.0));
    const SceneInterface share = read(slab_scene, {"interfaces.face.strength_ratio=0.5"});
    EXPECT_DOUBLE_EQ(share.strength_ratio.value_or(0.0), 0.5);
}

TEST_F(InterfaceOfVariant, IsNotSetByMistake)
{
    EXPECT_EQ(
        folder.message(slab_scene, {"interfaces.fase.strength_ratio=0.5"}),
        "--set 'interfaces.fase.strength_ratio=0.5': error[missing-key]: [interfaces.fase] has no regions\n"
        "expected: regions: The two regions. The soil of one slides: beside a solid that of the soil, of two "
        "soils that of the first.\n");
    EXPECT_EQ(
        folder.message(slab_scene, {"interfaces.face.friktion_angle=10"}),
        R"_(--set 'interfaces.face.friktion_angle=10': error[unknown-key]: unknown key 'friktion_angle' in [interfaces.face]
expected: one of regions, strength_ratio, friction_angle, cohesion, thickness
hint: did you mean friction_angle?
)_");
    EXPECT_EQ(
        folder.message(slab_scene, {"interfaces.face.strength_ratio=1.5"}),
        R"_(--set 'interfaces.face.strength_ratio=1.5': error[range]: interfaces.face.strength_ratio = 1.5 is out of range
expected: more than 0 and at most 1
)_");
    EXPECT_EQ(
        folder.message(slab_scene,
                       {"interfaces.face.strength_ratio=0.5", "interfaces.face.friction_angle=20"}),
        R"_(--set 'interfaces.face.friction_angle=20': error[conflict]: interfaces.face.friction_angle is given, and strength_ratio reduces that of the soil
expected: strength_ratio alone, or friction_angle with cohesion
hint: remove one of the two
)_");
}

TEST_F(InterfaceOfVariant, ChangesFromStageToStage)
{
    const std::string stages = "[[stages]]\nname = \"before\"\nkind = \"settle\"\n"
                               "[[stages]]\nname = \"after\"\nkind = \"shake\"\nduration = 1\n"
                               "[stages.interfaces.face]\nstrength_ratio = 0.5\n";
    const std::vector<SceneInterface> change = read_stages(stages);
    EXPECT_FALSE(change[0].strength_ratio);
    EXPECT_DOUBLE_EQ(change[1].strength_ratio.value_or(0.0), 0.5);
    const std::vector<SceneInterface> set =
        read_stages(stages, {"stages.after.interfaces.face.friction_angle=10"});
    EXPECT_DOUBLE_EQ(set[0].strength.friction, tan_of_20);
    EXPECT_FALSE(set[1].strength_ratio);
    EXPECT_DOUBLE_EQ(set[1].strength.friction, std::tan(10.0 * std::numbers::pi / 180.0));
}

TEST_F(InterfaceOfVariant, LeavesTheDensityOfSandToTheVariant)
{
    folder.write(
        "column.toml",
        fixtures::replaced(fixtures::column_scene,
                           "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3\n",
                           "model = \"ubcsand\"\nrelative_density = 0.5\n"));
    const std::string loose = "scene_version = 1\nbase = \"column.toml\"\n[materials.sand]\nn1_60 = 8\n";
    EXPECT_EQ(folder.message(loose), "");
    EXPECT_EQ(folder.message(loose, {"materials.sand.relative_density=0.4"}), "");
}

} // namespace
} // namespace quicksand
