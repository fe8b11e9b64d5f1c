// Strength parameters that say something against each other.
#include "tests/fixtures/scene_mistake.hpp"

#include <cmath>

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneLaws : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneLaws, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

TEST(SceneLaws, OfMohrAndCoulombAreRead)
{
    const fixtures::SceneFolder folder;
    const std::string text = fixtures::replaced(
        fixtures::column_scene, "model = \"linear_elastic\"",
        "model = \"mohr_coulomb\"\ncohesion = \"2 kPa\"\nfriction_angle = 30\ndilation_angle = \"0.1 rad\"");
    const SceneReading reading = folder.read(text);
    const auto& law = std::get<MohrCoulomb>(reading.scene.materials.at(0).material.law);
    EXPECT_EQ(law.shear_modulus, 60e6);
    EXPECT_EQ(law.poisson_ratio, 0.3);
    EXPECT_EQ(law.cohesion, 2000.0);
    EXPECT_NEAR(law.friction_angle, 0.5235987755982988, 1e-15);
    EXPECT_NEAR(law.dilation_angle, 0.1, 1e-15);
    EXPECT_TRUE(std::isinf(law.tension_strength));
}

TEST(SceneLaws, OfLargeStrainElasticityAreRead)
{
    const fixtures::SceneFolder folder;
    const std::string text =
        fixtures::replaced(fixtures::column_scene, "model = \"linear_elastic\"", "model = \"neo_hookean\"");
    const SceneReading reading = folder.read(text);
    EXPECT_EQ(std::get<NeoHookean>(reading.scene.materials.at(0).material.law).shear_modulus, 60e6);
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneLaws, testing::Values(
SceneMistake{"DilationAboveFriction",
    "model = \"linear_elastic\"",
    "model = \"mohr_coulomb\"\ncohesion = 0\nfriction_angle = 10\ndilation_angle = 12",
R"_(
scene.toml:23:18: error[range]: materials.sand.dilation_angle = 12 deg is more than friction_angle = 10 deg
   23 | dilation_angle = 12
      |                  ^~
expected: at most the angle of friction: otherwise shearing would produce energy
hint: sand dilates by about friction_angle - 30 deg
)_"},
SceneMistake{"AModulusByAnotherName",
    "shear_modulus = \"60 MPa\"",
    "youngs_modulus = \"150 MPa\"",
R"_(
scene.toml:21:1: error[unknown-key]: unknown key 'youngs_modulus' in [materials.sand]
   21 | youngs_modulus = "150 MPa"
      | ^~~~~~~~~~~~~~
expected: one of model, volumetric_strain, water, density, grain_density, porosity, hydraulic_conductivity, conductivity_gravity, saturation_above_water, permeability_law, shear_modulus, poisson_ratio, damping_ratio, damping_frequency
hint: shear_modulus = E / (2 (1 + poisson_ratio))
)_"},
SceneMistake{"FrictionInRadians",
    "model = \"linear_elastic\"",
    "model = \"mohr_coulomb\"\ncohesion = 0\nfriction_angle = 0.56\ndilation_angle = 0.6",
R"_(
scene.toml:22:18: warning[plausibility]: materials.sand.friction_angle = 0.56 deg is unusually small: angles are in degrees
   22 | friction_angle = 0.56
      |                  ^~~~
expected: usually 15 to 45 deg, or 0
hint: 0.56 rad is 32 deg
to accept it: accept = ["materials.sand.friction_angle"] at the top of the scene
scene.toml:23:18: error[range]: materials.sand.dilation_angle = 0.6 deg is more than friction_angle = 0.56 deg
   23 | dilation_angle = 0.6
      |                  ^~~
expected: at most the angle of friction: otherwise shearing would produce energy
hint: sand dilates by about friction_angle - 30 deg
)_"},
SceneMistake{"NoStrength",
    "model = \"linear_elastic\"",
    "model = \"mohr_coulomb\"\ncohesion = 0\nfriction_angle = 0",
R"_(
scene.toml:22:18: error[range]: materials.sand has no strength: cohesion and friction_angle are both 0
   22 | friction_angle = 0
      |                  ^
expected: one of them more than 0
)_"},
SceneMistake{"TensionBeyondTheTip",
    "model = \"linear_elastic\"",
    "model = \"mohr_coulomb\"\ncohesion = 1000\nfriction_angle = 45\ntension_strength = \"2 kPa\"",
R"_(
scene.toml:23:20: error[range]: materials.sand.tension_strength = 2000 Pa lies beyond the tip of the surface
   23 | tension_strength = "2 kPa"
      |                    ^~~~~~~
expected: at most cohesion / tan(friction_angle) = 1000 Pa
hint: remove it: the tip is the default
)_"},
SceneMistake{"StrengthOfAnElasticSoil",
    "model = \"linear_elastic\"",
    "model = \"linear_elastic\"\ncohesion = 1000",
R"_(
scene.toml:21:1: error[unused-key]: materials.sand.cohesion is not used with model = "linear_elastic"
   21 | cohesion = 1000
      | ^~~~~~~~
hint: remove it, or set model = "mohr_coulomb"
)_"},
SceneMistake{"LargeStrainElasticityThatSettles",
    "[materials.sand]\nmodel = \"linear_elastic\"",
    "[relaxation]\ndamping = 0.7\n\n[materials.sand]\nmodel = \"neo_hookean\"",
R"_(
scene.toml:23:9: error[conflict]: materials.sand.model = "neo_hookean" cannot settle in [relaxation]: its stress follows from its deformation, and the shaking takes the settled shape as undeformed
   23 | model = "neo_hookean"
      |         ^~~~~~~~~~~~~
expected: linear_elastic, mohr_coulomb, ubcsand or pm4sand beside [relaxation]
hint: remove [relaxation]: gravity is then switched on at once
)_"},
SceneMistake{"FrictionInPascal",
    "model = \"linear_elastic\"",
    "model = \"mohr_coulomb\"\ncohesion = 1000\nfriction_angle = \"0.6 MPa\"",
R"_(
scene.toml:22:18: error[unit]: materials.sand.friction_angle has the unit 'MPa'
   22 | friction_angle = "0.6 MPa"
      |                  ^~~~~~~~~
expected: one of deg, rad
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
