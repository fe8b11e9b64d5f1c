// Materials of UBCSAND: densities that are missing or told twice, stresses beyond what the sand can bear.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SandScenes : public testing::TestWithParam<SceneMistake> {};

TEST_P(SandScenes, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

const std::string elastic = "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3";

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SandScenes, testing::Values(
SceneMistake{"NoDensity",
    elastic,
    "model = \"ubcsand\"",
R"_(
scene.toml:19:1: error[missing-key]: [materials.sand] has no density
   19 | [materials.sand]
      | ^~~~~~~~~~~~~~~~
expected: one of n1_60, relative_density and preset
hint: n1_60 = 13.9, relative_density = 0.55 or preset = "nevada_sand_dr55" gives all other parameters their values
)_"},
SceneMistake{"TwoDensities",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\nrelative_density = 0.55",
R"_(
scene.toml:22:20: error[conflict]: [materials.sand] has a density already, by n1_60
   22 | relative_density = 0.55
      |                    ^~~~
expected: one of n1_60, relative_density and preset
hint: remove one of the two
)_"},
SceneMistake{"StiffnessOfAnotherModel",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\nshear_modulus = \"60 MPa\"",
R"_(
scene.toml:22:1: error[unused-key]: materials.sand.shear_modulus is not used with model = "ubcsand"
   22 | shear_modulus = "60 MPa"
      | ^~~~~~~~~~~~~
hint: remove it, or set model = "linear_elastic"
)_"},
SceneMistake{"DensityOfAnotherModel",
    elastic,
    elastic + "\nn1_60 = 13.9",
R"_(
scene.toml:23:1: error[unused-key]: materials.sand.n1_60 is not used with model = "linear_elastic"
   23 | n1_60 = 13.9
      | ^~~~~
hint: remove it, or set model = "ubcsand"
)_"},
SceneMistake{"MisspeltParameter",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\npeak_friction = 40.0",
R"_(
scene.toml:22:1: error[unknown-key]: unknown key 'peak_friction' in [materials.sand]
   22 | peak_friction = 40.0
      | ^~~~~~~~~~~~~
expected: one of model, volumetric_strain, water, density, grain_density, porosity, hydraulic_conductivity, conductivity_gravity, saturation_above_water, permeability_law, cohesion, n1_60, relative_density, preset, elastic_shear_number, small_strain_shear_modulus, elastic_bulk_number, elastic_shear_exponent, elastic_bulk_exponent, plastic_shear_number, plastic_shear_exponent, failure_ratio, constant_volume_friction_deg, peak_friction_deg, virgin_factor, secondary_factor, secondary_start, secondary_growth, reversal_tolerance, dilation_softening, softened_factor, law, confining_exponent, lateral_exponent, static_shear_stiffening, least_start_ratio, dilation_factor, dilation_strain, reference_strain, least_modulus_fraction, reconsolidation_slope, liquefied_conductivity, largest_ratio_step, largest_stress_step, stress_floor, shear_wave_velocity, static_poisson_ratio, ripple_strain, largest_porosity, smallest_porosity, resolved_floors, substep_tolerance
)_"},
SceneMistake{"UnknownFormOfTheLaw",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\nlaw = \"calibrate\"",
R"_(
scene.toml:22:7: error[word]: materials.sand.law = "calibrate" is not known
   22 | law = "calibrate"
      |       ^~~~~~~~~~~
expected: one of published, calibrated
hint: did you mean "calibrated"?
)_"},
SceneMistake{"TwoStiffnesses",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\nelastic_shear_number = 900\nshear_wave_velocity = \"180 m/s\"",
R"_(
scene.toml:23:23: error[conflict]: [materials.sand] has its elastic shear stiffness already, by elastic_shear_number
   23 | shear_wave_velocity = "180 m/s"
      |                       ^~~~~~~~~
expected: one of elastic_shear_number, small_strain_shear_modulus and shear_wave_velocity
hint: remove one of the two
)_"},
SceneMistake{"ConductivityThatFalls",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\nliquefied_conductivity = 0.5",
R"_(
scene.toml:22:26: error[range]: materials.sand.liquefied_conductivity = 0.5 is out of range
   22 | liquefied_conductivity = 0.5
      |                          ^~~
expected: at least 1
)_"},
SceneMistake{"LoosestDenserThanTheSand",
    elastic + "\ngrain_density = 2670\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n",
    "model = \"ubcsand\"\npreset = \"nevada_sand_dr55\"\ngrain_density = 2670\nporosity = 0.405\nlargest_porosity = 0.39\nhydraulic_conductivity = 5.8e-5\n",
R"_(
scene.toml:24:20: error[range]: materials.sand.largest_porosity = 0.39 is below porosity = 0.405
   24 | largest_porosity = 0.39
      |                    ^~~~
expected: the porosity of the sand at its loosest
)_"},
SceneMistake{"DensestLooserThanTheSand",
    elastic + "\ngrain_density = 2670\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n",
    "model = \"ubcsand\"\npreset = \"nevada_sand_dr55\"\ngrain_density = 2670\nporosity = 0.405\nsmallest_porosity = 0.42\nhydraulic_conductivity = 5.8e-5\n",
R"_(
scene.toml:24:21: error[range]: materials.sand.smallest_porosity = 0.42 is above porosity = 0.405
   24 | smallest_porosity = 0.42
      |                     ^~~~
expected: the porosity of the sand at its densest
)_"},
SceneMistake{"K0BeyondFailure",
    elastic + "\ngrain_density = 2670\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n",
    "model = \"ubcsand\"\npreset = \"nevada_sand_dr55\"\ngrain_density = 2670\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n\n[initial]\nk0 = 0.25\n",
R"_(
scene.toml:27:6: error[range]: initial.k0 = 0.25 is beyond the failure limit of materials.sand
   27 | k0 = 0.25
      |      ^~~~
expected: 0.278 to 3.596 for its peak_friction_deg = 34.392
hint: 0.5 is usual for sand that was not loaded before
)_"},
SceneMistake{"BulkModulusOfTheWater",
    elastic,
    "model = \"ubcsand\"\nn1_60 = 13.9\nelastic_bulk_number = 22000",
R"_(
scene.toml:19:1: error[range]: UBCSAND: elastic_bulk_number = 22000, but it must be the drained stiffness, at most about 10 times elastic_shear_number
   19 | [materials.sand]
      | ^~~~~~~~~~~~~~~~
scene.toml:22:23: warning[plausibility]: materials.sand.elastic_bulk_number = 22000 is unusually large
   22 | elastic_bulk_number = 22000
      |                       ^~~~~
expected: usually 50 to 5000
hint: did you mean 220 (22000 %)? this is the drained stiffness, not the pore water's
to accept it: accept = ["materials.sand.elastic_bulk_number"] at the top of the scene
)_"},
SceneMistake{"PercentOfRelativeDensity",
    elastic,
    "model = \"ubcsand\"\nrelative_density = 55",
R"_(
scene.toml:21:20: error[range]: materials.sand.relative_density = 55 is out of range
   21 | relative_density = 55
      |                    ^~
expected: more than 0 and at most 1
hint: did you mean 0.55 (55 %)?
)_"}
), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
