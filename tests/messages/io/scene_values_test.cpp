// Values of the wrong kind, unit or size.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneValues : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneValues, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneValues, testing::Values(
SceneMistake{"TextInsteadOfNumber",
    "poisson_ratio = 0.3",
    "poisson_ratio = \"low\"",
R"_(
scene.toml:22:17: error[type]: materials.sand.poisson_ratio is text
   22 | poisson_ratio = "low"
      |                 ^~~~~
expected: a number
)_"},
SceneMistake{"NumberInQuotes",
    "level = 0.3175",
    "level = \"0.3175\"",
R"_(
scene.toml:17:9: error[unit]: water.level stands in quotes but has no unit
   17 | level = "0.3175"
      |         ^~~~~~~~
expected: one of m, cm, mm
hint: without quotes, 0.3175 m is understood
)_"},
SceneMistake{"BooleanInsteadOfNumber",
    "frequency = 180",
    "frequency = true",
R"_(
scene.toml:47:13: error[type]: motion.frequency is true or false
   47 | frequency = true
      |             ^~~~
expected: a number in Hz, or a quantity in quotes as "1 kHz"
)_"},
SceneMistake{"MoreFramesThanCanBeNumbered",
    "end_time = 0.2",
    "end_time = 0.2\n\n[output]\nframe_interval = 1e-9",
R"_(
scene.toml:53:18: error[range]: output.frame_interval is 1e-9 s, 2e8 times in the run of 0.2 s
   53 | frame_interval = 1e-9
      |                  ^~~~
expected: at most 1e6 times, or 0 for none
)_"},
SceneMistake{"DateInsteadOfNumber",
    "end_time = 0.2",
    "end_time = 2021-05-27",
R"_(
scene.toml:50:12: error[type]: run.end_time is a date or time
   50 | end_time = 2021-05-27
      |            ^~~~~~~~~~
expected: a number in s, or a quantity in quotes as "1 ms"
)_"},
SceneMistake{"NumberInsteadOfText",
    "material = \"sand\"",
    "material = 1",
R"_(
scene.toml:28:12: error[type]: regions.sand.material is a number
   28 | material = 1
      |            ^
expected: text in quotes
)_"},
SceneMistake{"FractionInsteadOfCount",
    "particles_per_cell = [3, 3]",
    "particles_per_cell = [3, 2.5]",
R"_(
scene.toml:11:26: error[type]: sampling.particles_per_cell = 2.5 is not a whole number
   11 | particles_per_cell = [3, 2.5]
      |                          ^~~
expected: a whole number, 1 to 10
)_"},
SceneMistake{"WholeNumberWithAPoint",
    "particles_per_cell = [3, 3]",
    "particles_per_cell = [3, 2.0]",
R"_(
scene.toml:11:26: error[type]: sampling.particles_per_cell = 2.0 is not a whole number
   11 | particles_per_cell = [3, 2.0]
      |                          ^~~
expected: a whole number, 1 to 10
hint: write it without the decimal point
)_"},
SceneMistake{"NumberInsteadOfPair",
    "particles_per_cell = [3, 3]",
    "particles_per_cell = 3",
R"_(
scene.toml:11:22: error[type]: sampling.particles_per_cell is a number
   11 | particles_per_cell = 3
      |                      ^
expected: two whole numbers, as [3, 3]
)_"},
SceneMistake{"NumberInsteadOfTable",
    "file = \"column.geo\"",
    "file = \"column.geo\"\nparameters = 3",
R"_(
scene.toml:6:14: error[type]: geometry.parameters is a number
    6 | parameters = 3
      |              ^
expected: a table of numbers, as { crest_width = 0.15 }
)_"},
SceneMistake{"TextInsteadOfList",
    "title = \"column\"",
    "accept = \"materials.sand.porosity\"",
R"_(
scene.toml:2:10: error[type]: accept is text
    2 | accept = "materials.sand.porosity"
      |          ^~~~~~~~~~~~~~~~~~~~~~~~~
expected: a list of texts in quotes, as ["materials.sand.porosity"]
)_"},
SceneMistake{"EmptyText",
    "material = \"sand\"",
    "material = \"\"",
R"_(
scene.toml:28:12: error[range]: regions.sand.material is empty
   28 | material = ""
      |            ^~
expected: text in quotes
)_"},
SceneMistake{"WrongLength",
    "at = [0.03, 0.3]",
    "at = [0.03, 0.3, 0]",
R"_(
scene.toml:54:6: error[type]: probes.crest.at is a list of 3
   54 | at = [0.03, 0.3, 0]
      |      ^~~~~~~~~~~~~~
expected: [x, y], two numbers in m
)_"},
SceneMistake{"WrongUnit",
    "shear_modulus = \"60 MPa\"",
    "shear_modulus = \"60 MN\"",
R"_(
scene.toml:21:17: error[unit]: materials.sand.shear_modulus has the unit 'MN'
   21 | shear_modulus = "60 MN"
      |                 ^~~~~~~
expected: one of Pa, kPa, MPa, GPa
)_"},
SceneMistake{"UnitInWrongCase",
    "shear_modulus = \"60 MPa\"",
    "shear_modulus = \"60 mpa\"",
R"_(
scene.toml:21:17: error[unit]: materials.sand.shear_modulus has the unit 'mpa'
   21 | shear_modulus = "60 mpa"
      |                 ^~~~~~~~
expected: one of Pa, kPa, MPa, GPa
hint: did you mean MPa?
)_"},
SceneMistake{"UnitOfAnotherDimension",
    "hydraulic_conductivity = 5.8e-5",
    "hydraulic_conductivity = \"1e-12 m2\"",
R"_(
scene.toml:25:26: error[unit]: materials.sand.hydraulic_conductivity has the unit 'm2'
   25 | hydraulic_conductivity = "1e-12 m2"
      |                          ^~~~~~~~~~
expected: one of m/s, cm/s, mm/s, m/day, m/d
)_"},
SceneMistake{"OutOfRange",
    "poisson_ratio = 0.3",
    "poisson_ratio = 0.5",
R"_(
scene.toml:22:17: error[range]: materials.sand.poisson_ratio = 0.5 is out of range
   22 | poisson_ratio = 0.5
      |                 ^~~
expected: at least 0 and less than 0.5
)_"},
SceneMistake{"PercentInsteadOfFraction",
    "porosity = 0.405",
    "porosity = 40.5",
R"_(
scene.toml:24:12: error[range]: materials.sand.porosity = 40.5 is out of range
   24 | porosity = 40.5
      |            ^~~~
expected: more than 0 and less than 1
hint: did you mean 0.405 (40.5 %)?
)_"},
SceneMistake{"NotFinite",
    "level = 0.3175",
    "level = inf",
R"_(
scene.toml:17:9: error[not-finite]: water.level = inf is not a finite number
   17 | level = inf
      |         ^~~
expected: a number in m, or a quantity in quotes as "1 cm"
)_"},
SceneMistake{"BeyondAllNumbersInItsUnit",
    "shear_modulus = \"60 MPa\"",
    "shear_modulus = \"1e308 MPa\"",
R"_(
scene.toml:21:17: error[not-finite]: materials.sand.shear_modulus is not a finite number
   21 | shear_modulus = "1e308 MPa"
      |                 ^~~~~~~~~~~
expected: a number in Pa, or a quantity in quotes as "1 kPa"
)_"},
SceneMistake{"NotANumber",
    "porosity = 0.405",
    "porosity = nan",
R"_(
scene.toml:24:12: error[not-finite]: materials.sand.porosity = nan is not a finite number
   24 | porosity = nan
      |            ^~~
expected: a number
)_"},
SceneMistake{"UnknownWord",
    "model = \"linear_elastic\"",
    "model = \"linear-elastic\"",
R"_(
scene.toml:20:9: error[word]: materials.sand.model = "linear-elastic" is not known
   20 | model = "linear-elastic"
      |         ^~~~~~~~~~~~~~~~
expected: one of linear_elastic, mohr_coulomb, ubcsand, neo_hookean, pm4sand
hint: did you mean "linear_elastic"?
)_"},
SceneMistake{"RampLongerThanTheShaking",
    "frequency = 180",
    "frequency = 180\ncycles = 3\nramp_cycles = 5",
R"_(
scene.toml:49:15: warning[motion]: the amplitude rises over 5 cycles but there are only 3
   49 | ramp_cycles = 5
      |               ^
to accept it: accept = ["motion.ramp_cycles"] at the top of the scene
)_"},
SceneMistake{"KilopascalGivenAsPascal",
    "shear_modulus = \"60 MPa\"",
    "shear_modulus = 60e3",
R"_(
scene.toml:21:17: warning[plausibility]: materials.sand.shear_modulus = 60000 Pa is unusually small
   21 | shear_modulus = 60e3
      |                 ^~~~
expected: usually 1e5 to 1e11 Pa
hint: did you mean "60000 kPa"?
to accept it: accept = ["materials.sand.shear_modulus"] at the top of the scene
)_"},
SceneMistake{"VoidRatioInsteadOfPorosity",
    "porosity = 0.405",
    "porosity = 0.8",
R"_(
scene.toml:24:12: warning[plausibility]: materials.sand.porosity = 0.8 is unusually large
   24 | porosity = 0.8
      |            ^~~
expected: usually 0.2 to 0.7
hint: porosity is the void volume over the total volume, not the void ratio
to accept it: accept = ["materials.sand.porosity"] at the top of the scene
)_"},
SceneMistake{"PermeabilityInsteadOfConductivity",
    "hydraulic_conductivity = 5.8e-5",
    "hydraulic_conductivity = 5.8e-12",
R"_(
scene.toml:25:26: warning[plausibility]: materials.sand.hydraulic_conductivity = 5.8e-12 m/s is unusually small
   25 | hydraulic_conductivity = 5.8e-12
      |                          ^~~~~~~
expected: usually 1e-10 to 1 m/s
hint: this is Darcy's conductivity in m/s, not an intrinsic permeability in m2, not k/gamma_w
to accept it: accept = ["materials.sand.hydraulic_conductivity"] at the top of the scene
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
