// Keys and tables that are misspelt, missing or out of place.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneKeys : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneKeys, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneKeys, testing::Values(
SceneMistake{"UnknownKey",
    "porosity = 0.405",
    "porosty = 0.405",
R"_(
scene.toml:24:1: error[unknown-key]: unknown key 'porosty' in [materials.sand]
   24 | porosty = 0.405
      | ^~~~~~~
expected: one of model, volumetric_strain, water, density, grain_density, porosity, hydraulic_conductivity, conductivity_gravity, saturation_above_water, permeability_law, shear_modulus, poisson_ratio, damping_ratio, damping_frequency
hint: did you mean porosity?
)_"},
SceneMistake{"KeyOfAnotherTable",
    "[run]\n",
    "[run]\ncell_size = 0.01\n",
R"_(
scene.toml:50:1: error[unknown-key]: unknown key 'cell_size' in [run]
   50 | cell_size = 0.01
      | ^~~~~~~~~
expected: end_time
hint: cell_size belongs in [grid]
)_"},
SceneMistake{"UnknownTable",
    "[grid]",
    "[gird]",
R"_(
scene.toml:7:1: error[unknown-table]: unknown table [gird]
    7 | [gird]
      | ^~~~~~
expected: one of geometry, grid, sampling, analysis, gravity, water, materials, regions, interfaces, boundaries, initial, relaxation, motion, run, output, probes, stages, figures, verification
hint: did you mean grid?
)_"},
SceneMistake{"UnknownTopLevelKey",
    "title =",
    "titel =",
R"_(
scene.toml:2:1: error[unknown-key]: unknown key 'titel'
    2 | titel = "column"
      | ^~~~~
expected: one of scene_version, title, base, without, accept
hint: did you mean title?
)_"},
SceneMistake{"ValueInsteadOfTable",
    "[gravity]\nacceleration = \"120 g\"\n\n[water]\nlevel = 0.3175\n",
    "[materials]\nclay = 3\n",
R"_(
scene.toml:14:8: error[type]: materials.clay is a number
   14 | clay = 3
      |        ^
expected: a table, that is a line [materials.clay] and its keys below it
scene.toml:22:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect in a dry scene
   22 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: add a table [water], or remove the key
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"},
SceneMistake{"MissingKey",
    "porosity = 0.405\n",
    "",
R"_(
scene.toml:19:1: error[missing-key]: [materials.sand] has no porosity
   19 | [materials.sand]
      | ^~~~~~~~~~~~~~~~
expected: porosity: Initial porosity: void volume over total volume.
)_"},
SceneMistake{"MissingTable",
    "[run]\nend_time = 0.2\n",
    "",
R"_(
scene.toml: error[missing-table]: there is no table [run]
expected: a table [run] with end_time: The run.
)_"},
SceneMistake{"MissingVersion",
    "scene_version = 1\n",
    "",
R"_(
scene.toml: error[missing-key]: the scene has no scene_version
expected: scene_version: Version of the scene format: 1.
hint: begin the scene with the line scene_version = 1
)_"},
SceneMistake{"NewerVersion",
    "scene_version = 1",
    "scene_version = 2",
R"_(
scene.toml:1:17: error[version]: scene_version 2 is not known to this program
    1 | scene_version = 2
      |                 ^
expected: scene_version = 1
hint: the scene is for a newer version of Quicksand
)_"},
SceneMistake{"VersionBeforeTheFirst",
    "scene_version = 1",
    "scene_version = 0",
R"_(
scene.toml:1:17: error[version]: scene_version 0 is not known to this program
    1 | scene_version = 0
      |                 ^
expected: scene_version = 1
hint: the first version is 1
)_"},
SceneMistake{"KeyOfAnotherKind",
    "kind = \"sine\"",
    "kind = \"none\"",
R"_(
scene.toml:46:1: error[unused-key]: motion.amplitude is not used with kind = "none"
   46 | amplitude = "24 g"
      | ^~~~~~~~~
hint: remove it, or set kind = "sine"
scene.toml:47:1: error[unused-key]: motion.frequency is not used with kind = "none"
   47 | frequency = 180
      | ^~~~~~~~~
hint: remove it, or set kind = "sine"
)_"},
SceneMistake{"KeyOfDrySceneOnly",
    "[water]\nlevel = 0.3175\n",
    "",
R"_(
scene.toml:23:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect in a dry scene
   23 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: add a table [water], or remove the key
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"},
SceneMistake{"ConductivityWithoutFlow",
    "level = 0.3175",
    "level = 0.3175\nflow = \"undrained\"",
R"_(
scene.toml:26:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect with water.flow = "undrained"
   26 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: remove it, or set water.flow = "coupled"
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"},
SceneMistake{"CavitiesInDrainedWater",
    "level = 0.3175",
    "level = 0.3175\ncavitation_pressure = \"2.3 kPa\"\nflow = \"drained\"",
R"_(
scene.toml:18:1: error[unused-key]: water.cavitation_pressure is not used with flow = "drained"
   18 | cavitation_pressure = "2.3 kPa"
      | ^~~~~~~~~~~~~~~~~~~
hint: remove it, or set flow = "coupled"
scene.toml:27:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect with water.flow = "drained"
   27 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: remove it, or set water.flow = "coupled"
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"},
SceneMistake{"MisspeltFlow",
    "level = 0.3175",
    "level = 0.3175\nflow = \"undraind\"",
R"_(
scene.toml:18:8: error[word]: water.flow = "undraind" is not known
   18 | flow = "undraind"
      |        ^~~~~~~~~~
expected: one of coupled, undrained, drained
hint: did you mean "undrained"?
)_"},
SceneMistake{"LawOfAPorosityThatStays",
    "hydraulic_conductivity = 5.8e-5",
    "hydraulic_conductivity = 5.8e-5\npermeability_law = \"kozeny_carman\"\n[analysis]\nstrain = \"small\"",
R"_(
scene.toml:26:20: warning[unused]: materials.sand.permeability_law has no effect in small strain: the porosity stays
   26 | permeability_law = "kozeny_carman"
      |                    ^~~~~~~~~~~~~~~
hint: set analysis.strain = "large", or remove it
to accept it: accept = ["materials.sand.permeability_law"] at the top of the scene
)_"},
SceneMistake{"ImplicitPressureWithoutFlow",
    "level = 0.3175",
    "level = 0.3175\nflow = \"undrained\"\n[analysis]\nscheme = \"semi_implicit\"",
R"_(
scene.toml:20:10: error[combination]: scheme = "semi_implicit" has no pressure to solve for with water.flow = "undrained"
   20 | scheme = "semi_implicit"
      |          ^~~~~~~~~~~~~~~
expected: scheme = "explicit", or water.flow = "coupled"
scene.toml:28:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect with water.flow = "undrained"
   28 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: remove it, or set water.flow = "coupled"
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"},
SceneMistake{"ImplicitStepsOfUndrainedWater",
    "level = 0.3175",
    "level = 0.3175\nflow = \"undrained\"\n[analysis]\nscheme = \"implicit\"",
R"_(
scene.toml:20:10: error[combination]: scheme = "implicit" does not resist the waves of water that moves with the grains, water.flow = "undrained"
   20 | scheme = "implicit"
      |          ^~~~~~~~~~
expected: scheme = "explicit", or water.flow = "coupled" with a low conductivity
scene.toml:28:1: warning[unused]: materials.sand.hydraulic_conductivity has no effect with water.flow = "undrained"
   28 | hydraulic_conductivity = 5.8e-5
      | ^~~~~~~~~~~~~~~~~~~~~~
hint: remove it, or set water.flow = "coupled"
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"},
SceneMistake{"CavitationAboveTheAtmosphere",
    "level = 0.3175",
    "level = 0.3175\ncavitation_pressure = \"120 kPa\"",
R"_(
scene.toml:18:23: error[range]: water.cavitation_pressure = 1.2e5 Pa is out of range
   18 | cavitation_pressure = "120 kPa"
      |                       ^~~~~~~~~
expected: less than 1e5 Pa
)_"},
SceneMistake{"AcceptOfNoKey",
    "title = \"column\"",
    "accept = [\"materials.sand.porosty\"]",
R"_(
scene.toml:2:10: error[unknown-key]: accept names "materials.sand.porosty", which is no key
    2 | accept = ["materials.sand.porosty"]
      |          ^~~~~~~~~~~~~~~~~~~~~~~~~~
expected: the path of a key, as materials.sand.porosity
hint: did you mean "materials.sand.porosity"?
)_"},
SceneMistake{"ProfileWithoutEnd",
    "kind = \"surface\"",
    "kind = \"profile\"",
R"_(
scene.toml:52:1: error[missing-key]: [probes.crest] has no to
   52 | [probes.crest]
      | ^~~~~~~~~~~~~~
expected: to [m]: End of a profile.
)_"},
SceneMistake{"ProfileWithoutLength",
    "kind = \"surface\"\nat = [0.03, 0.3]",
    "kind = \"profile\"\nat = [0.03, 0.3]\nto = [0.03, 0.3]",
R"_(
scene.toml:55:6: error[range]: the profile has no length
   55 | to = [0.03, 0.3]
      |      ^~~~~~~~~~~
expected: a point other than at
)_"},
SceneMistake{"ProbesThatShareTheirFile",
    "[probes.crest]",
    "[probes.Crest]\nkind = \"surface\"\nat = [0.01, 0.3]\n\n[probes.crest]",
R"_(
scene.toml:56:1: error[name]: the probes "Crest" and "crest" differ in capitals only
   56 | [probes.crest]
      | ^~~~~~~~~~~~~~
)_"},
SceneMistake{"ProbeNameNoFile",
    "[probes.crest]",
    "[probes.\"a/b\"]",
R"_(
scene.toml:52:1: error[name]: the probe's name cannot be that of a file
   52 | [probes."a/b"]
      | ^~~~~~~~~~~~~~
expected: at most 100 characters, none of / \ : * ? " < > |, no leading dot
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
