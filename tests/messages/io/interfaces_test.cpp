// Interfaces between regions that do not touch, have no strength or are given twice.
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneFolder;

const std::string scene = R"(scene_version = 1
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
    const std::string text = fixtures::replaced(scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(SceneFolder().assembly_message(text, section()), mistake.message.substr(1));
}

TEST(SoundInterface, IsNotCommented)
{
    EXPECT_EQ(SceneFolder().assembly_message(scene, section()), "");
}

TEST(SoundInterface, WaitsForSoilThatAStagePlaces)
{
    const std::string waits =
        fixtures::replaced(scene, "[regions.wall]\n", "[regions.wall]\nsoil = \"absent\"\n");
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
        scene,
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

} // namespace
} // namespace quicksand
