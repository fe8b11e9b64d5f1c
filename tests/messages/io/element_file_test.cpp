// Mistakes in a file of element tests: the place, what is allowed and the cure.
#include "tests/fixtures/element_example.hpp"
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::ElementFolder;
using fixtures::SceneMistake;

class ElementMistakes : public testing::TestWithParam<SceneMistake> {};

TEST_P(ElementMistakes, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const ElementFolder folder;
    const std::string text = fixtures::replaced(fixtures::sound_tests, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Files, ElementMistakes, testing::Values(
SceneMistake{"NoVersion",
    "test_version = 1\n",
    "\n",
R"_(
test.toml: error[missing-key]: the test file has no test_version
expected: test_version: Version of the format of element tests: 1.
hint: begin the test file with the line test_version = 1
)_"},
SceneMistake{"OtherVersion",
    "test_version = 1\n",
    "test_version = 2\n",
R"_(
test.toml:1:16: error[version]: test_version 2 is not known to this program
    1 | test_version = 2
      |                ^
expected: test_version = 1
)_"},
SceneMistake{"MisspeltKey",
    "csr = [0.15, 0.2, 0.3]",
    "crs = [0.15, 0.2, 0.3]",
R"_(
test.toml:12:1: error[unknown-key]: unknown key 'crs' in [tests.strength]
   12 | crs = [0.15, 0.2, 0.3]
      | ^~~
expected: one of kind, material, vertical_stress, k0, static_shear_ratio, csr, cycles, cycles_after_liquefaction, largest_shear_strain, vary, values, criterion, data, data_label
hint: did you mean csr?
)_"},
SceneMistake{"OtherKind",
    "kind = \"cyclic_shear_stress_controlled\"",
    "kind = \"cyclic_shear_strain_controlled\"",
R"_(
test.toml:8:1: error[missing-key]: [tests.strength] has no shear_strains
    8 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
expected: shear_strains: Amplitudes of the shear strain, one test each.
test.toml:12:1: error[unused-key]: tests.strength.csr is not used with kind = "cyclic_shear_strain_controlled"
   12 | csr = [0.15, 0.2, 0.3]
      | ^~~
hint: remove it, or set kind = "cyclic_shear_stress_controlled"
)_"},
SceneMistake{"SingleRatio",
    "csr = [0.15, 0.2, 0.3]",
    "csr = 0.15",
R"_(
test.toml:12:7: error[type]: tests.strength.csr is a number
   12 | csr = 0.15
      |       ^~~~
expected: a list, each a number
)_"},
SceneMistake{"NoRatios",
    "csr = [0.15, 0.2, 0.3]",
    "csr = []",
R"_(
test.toml:12:7: error[type]: tests.strength.csr is an empty list
   12 | csr = []
      |       ^~
expected: a list, each a number
)_"},
SceneMistake{"NegativeRatio",
    "csr = [0.15, 0.2, 0.3]",
    "csr = [0.15, -0.2]",
R"_(
test.toml:12:14: error[range]: tests.strength.csr = -0.2 is out of range
   12 | csr = [0.15, -0.2]
      |              ^~~~
expected: more than 0
)_"},
SceneMistake{"StressInKilopascals",
    "vertical_stress = \"100 kPa\"",
    "vertical_stress = 100",
R"_(
test.toml:8:1: error[consolidation]: a mean stress of 75 Pa is below the least of the model, 500 Pa (stress_floor)
    8 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
hint: raise vertical_stress, or lower stress_floor
test.toml:10:19: warning[plausibility]: tests.strength.vertical_stress = 100 Pa is unusually small
   10 | vertical_stress = 100
      |                   ^~~
expected: usually 5000 to 3e6 Pa
hint: did you mean "100 kPa"?
to accept it: accept = ["tests.strength.vertical_stress"] at the top of the test file
)_"},
SceneMistake{"SpecimenThatFails",
    "k0 = 0.5",
    "k0 = 0.2",
R"_(
test.toml:8:1: error[consolidation]: the specimen fails in consolidation: its stress ratio t/s = 0.667 is above the failure limit sin phi_f = 0.565
    8 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
hint: bring k0 nearer to 1
test.toml:11:6: warning[plausibility]: tests.strength.k0 = 0.2 is unusually small
   11 | k0 = 0.2
      |      ^~~
expected: usually 0.3 to 2
to accept it: accept = ["tests.strength.k0"] at the top of the test file
)_"},
SceneMistake{"StaticShearAboveTheStrength",
    "k0 = 0.5",
    "static_shear_ratio = 0.39",
R"_(
test.toml:8:1: error[consolidation]: the specimen fails in consolidation: its stress ratio t/s = 0.618 is above the failure limit sin phi_f = 0.565
    8 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
hint: reduce static_shear_ratio, or bring k0 nearer to 1
)_"},
SceneMistake{"SpecimenBelowTheLeastStress",
    "n1_60 = 13.9",
    "n1_60 = 13.9\nstress_floor = \"80 kPa\"",
R"_(
test.toml:7:16: warning[plausibility]: materials.sand.stress_floor = 80000 Pa is unusually large
    7 | stress_floor = "80 kPa"
      |                ^~~~~~~~
expected: usually 10 to 5000 Pa
hint: did you mean "80 Pa"?
to accept it: accept = ["materials.sand.stress_floor"] at the top of the test file
test.toml:9:1: error[consolidation]: a mean stress of 75000 Pa is below the least of the model, 80000 Pa (stress_floor)
    9 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
hint: raise vertical_stress, or lower stress_floor
)_"},
SceneMistake{"StressBelowTheLeast",
    "[tests.strength]",
    "[tests.compression]\nkind = \"oedometer\"\nstresses = [4e5, 400]\n[tests.strength]",
R"_(
test.toml:10:12: error[range]: tests.compression.stresses has 400 Pa, which is below the least stress of the model
   10 | stresses = [4e5, 400]
      |            ^~~~~~~~~~
expected: at least 500 Pa, the stress_floor
test.toml:10:18: warning[plausibility]: tests.compression.stresses = 400 Pa is unusually small
   10 | stresses = [4e5, 400]
      |                  ^~~
expected: usually 1000 to 1e7 Pa
hint: did you mean "400 kPa"?
to accept it: accept = ["tests.compression.stresses"] at the top of the test file
)_"},
SceneMistake{"UnknownMaterial",
    "k0 = 0.5",
    "material = \"snad\"",
R"_(
test.toml:11:12: error[unknown-material]: there is no material "snad"
   11 | material = "snad"
      |            ^~~~~~
expected: sand
hint: did you mean "sand"?
)_"},
SceneMistake{"NoMaterialAmongTwo",
    "[tests.strength]",
    "[materials.silt]\nmodel = \"ubcsand\"\nn1_60 = 8\n[tests.strength]",
R"_(
test.toml:11:1: error[unknown-material]: there are several materials and the test names none
   11 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
expected: one of sand, silt
)_"},
SceneMistake{"NoDensity",
    "n1_60 = 13.9",
    "failure_ratio = 0.8",
R"_(
test.toml:4:1: error[missing-key]: [materials.sand] has no density
    4 | [materials.sand]
      | ^~~~~~~~~~~~~~~~
expected: one of n1_60, relative_density and preset
hint: n1_60 = 13.9, relative_density = 0.55 or preset = "nevada_sand_dr55" gives all other parameters their values
)_"},
SceneMistake{"NameOfNoFolder",
    "[tests.strength]",
    "[tests.\"a/b\"]",
R"_(
test.toml:8:1: error[name]: the test's name cannot be that of a folder
    8 | [tests."a/b"]
      | ^~~~~~~~~~~~~
expected: at most 100 characters, none of / \ : * ? " < > |, no leading dot
)_"},
SceneMistake{"AcceptsNoKey",
    "title = \"sand\"",
    "accept = [\"tests.strength.ko\"]",
R"_(
test.toml:2:10: error[unknown-key]: accept names "tests.strength.ko", which is no key
    2 | accept = ["tests.strength.ko"]
      |          ^~~~~~~~~~~~~~~~~~~~~
expected: the path of a key, as tests.strength.k0
hint: did you mean "tests.strength.k0"?
)_"}
), fixtures::name_of);

INSTANTIATE_TEST_SUITE_P(Variations, ElementMistakes, testing::Values(
SceneMistake{"NothingVaried",
    "cycles = 30",
    "values = [5, 10]",
R"_(
test.toml:8:1: error[missing-key]: [tests.strength] has no vary
    8 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
expected: vary = "k0" and values = [0.4, 0.5, 1.0], for example
)_"},
SceneMistake{"NoValues",
    "cycles = 30",
    "vary = \"k0\"",
R"_(
test.toml:8:1: error[missing-key]: [tests.strength] has no values
    8 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
expected: vary = "k0" and values = [0.4, 0.5, 1.0], for example
)_"},
SceneMistake{"ValueOutOfRange",
    "cycles = 30",
    "vary = \"failure_ratio\"\nvalues = [0.8, 1.2]",
R"_(
test.toml:14:16: error[range]: materials.sand.failure_ratio = 1.2 is out of range
   14 | values = [0.8, 1.2]
      |                ^~~
expected: at least 0 and less than 1
)_"},
SceneMistake{"DensityOutOfRange",
    "cycles = 30",
    "vary = \"n1_60\"\nvalues = [5, -10]",
R"_(
test.toml:14:14: error[range]: materials.sand.n1_60 = -10 is out of range
   14 | values = [5, -10]
      |              ^~~
expected: more than 0 and at most 50
)_"},
SceneMistake{"ValueOfAnotherUnit",
    "cycles = 30",
    "vary = \"vertical_stress\"\nvalues = [\"50 kPa\", \"2 m\"]",
R"_(
test.toml:14:21: error[unit]: tests.strength.vertical_stress has the unit 'm'
   14 | values = ["50 kPa", "2 m"]
      |                     ^~~~~
expected: one of Pa, kPa, MPa, GPa
)_"},
SceneMistake{"ValueThatCannotBeConsolidated",
    "cycles = 30",
    "vary = \"static_shear_ratio\"\nvalues = [0.1, 0.39]",
R"_(
test.toml:14:16: error[consolidation]: the specimen fails in consolidation: its stress ratio t/s = 0.618 is above the failure limit sin phi_f = 0.565
   14 | values = [0.1, 0.39]
      |                ^~~~
hint: reduce static_shear_ratio, or bring k0 nearer to 1
)_"},
SceneMistake{"MohrCoulombBeyondItsStrength",
    "model = \"ubcsand\"\nn1_60 = 13.9",
    "model = \"mohr_coulomb\"\nshear_modulus = \"10 MPa\"\npoisson_ratio = 0.3\nfriction_angle = \"10 deg\"",
R"_(
test.toml:10:1: error[consolidation]: the specimen fails in consolidation: its largest principal stress is 100000 Pa, and beside the least of 50000 Pa the soil bears 71013.8 Pa
   10 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
hint: bring k0 nearer to 1
)_"},
SceneMistake{"RubberThatIsTooSoft",
    "model = \"ubcsand\"\nn1_60 = 13.9",
    "model = \"neo_hookean\"\nshear_modulus = \"1 Pa\"\npoisson_ratio = 0.3",
R"_(
test.toml:6:17: warning[plausibility]: materials.sand.shear_modulus = 1 Pa is unusually small
    6 | shear_modulus = "1 Pa"
      |                 ^~~~~~
expected: usually 1e5 to 1e11 Pa
hint: did you mean "1 MPa"?
to accept it: accept = ["materials.sand.shear_modulus"] at the top of the test file
test.toml:9:1: error[consolidation]: the specimen is too soft for these stresses: no strain leads to them
    9 | [tests.strength]
      | ^~~~~~~~~~~~~~~~
hint: lower vertical_stress, or take stiffer soil
)_"},
SceneMistake{"KeyOfAnotherLaw",
    "n1_60 = 13.9",
    "n1_60 = 13.9\nshear_modulus = \"10 MPa\"",
R"_(
test.toml:7:1: error[unused-key]: materials.sand.shear_modulus is not used with model = "ubcsand"
    7 | shear_modulus = "10 MPa"
      | ^~~~~~~~~~~~~
hint: remove it, or set model = "linear_elastic"
)_"},
SceneMistake{"ASecondDensity",
    "cycles = 30",
    "vary = \"relative_density\"\nvalues = [0.5]",
R"_(
test.toml:14:11: error[conflict]: [materials.sand] has a density already, by n1_60
   14 | values = [0.5]
      |           ^~~
expected: one of n1_60, relative_density and preset
hint: remove one of the two
)_"},
SceneMistake{"ValuesThatAreNone",
    "cycles = 30",
    "vary = \"k0\"\nvalues = [true]",
R"_(
test.toml:14:10: error[type]: tests.strength.values is not a list of numbers
   14 | values = [true]
      |          ^~~~~~
expected: a list of numbers, or of quantities in quotes
)_"}
), fixtures::name_of);
// clang-format on

TEST(ElementMessages, AKeyThatCannotBeVariedIsNamedWithThoseThatCan)
{
    const ElementFolder folder;
    const std::string message = folder.message(
        fixtures::replaced(fixtures::sound_tests, "cycles = 30", "vary = \"n1_06\"\nvalues = [5]"));
    EXPECT_TRUE(message.starts_with(
        "test.toml:13:8: error[unknown-key]: \"n1_06\" is no number of the material or the "
        "test\n"))
        << message;
    EXPECT_NE(message.find("expected: one of cohesion, n1_60, relative_density, "), std::string::npos)
        << message;
    EXPECT_NE(message.find("hint: did you mean \"n1_60\"?"), std::string::npos) << message;
}

TEST(ElementMessages, MistakesOfAllTestsAreShownTogether)
{
    const ElementFolder folder;
    const std::string message =
        folder.message(fixtures::replaced(fixtures::sound_tests, "cycles = 30", "data = \"none.csv\"") +
                       "[tests.other]\nkind = \"oedometer\"\nstresses = [2e5]\nk0 = 0.1\n");
    EXPECT_NE(message.find("'none.csv' does not exist"), std::string::npos) << message;
    EXPECT_NE(message.find("test.toml:14:1: error[consolidation]"), std::string::npos) << message;
}

TEST(ElementMessages, AFileThatIsNotThereIsNamed)
{
    try {
        read_element_file("nowhere/test.toml", {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), "nowhere/test.toml: error[file]: does not exist");
    }
}

} // namespace
} // namespace quicksand
