// Mistakes in measured points that a file of element tests names: the place, what is allowed and the cure.
#include "tests/fixtures/element_example.hpp"
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::ElementFolder;
using fixtures::SceneMistake;

class ElementData : public testing::TestWithParam<SceneMistake> {};

TEST_P(ElementData, IsReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const ElementFolder folder;
    folder.write("no_columns.csv", "CSR;N\n0.1;15\n");
    folder.write("words.csv", "CSR,N\n0.1,15\n0.2,many\n");
    folder.write("percent.csv", "CSR,N\n20,8\n15,25\n");
    folder.write("empty.csv", "# nothing yet\nCSR,N\n");
    const std::string text = fixtures::replaced(fixtures::sound_tests, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, ElementData, testing::Values(
SceneMistake{"MissingFile",
    "cycles = 30",
    "data = \"none.csv\"",
R"_(
test.toml:13:8: error[file]: 'none.csv' does not exist
   13 | data = "none.csv"
      |        ^~~~~~~~~~
hint: the path is relative to the file that names it
)_"},
SceneMistake{"NoColumns",
    "cycles = 30",
    "data = \"no_columns.csv\"",
R"_(
test.toml:13:8: error[data]: 'no_columns.csv': it has no columns CSR and N
   13 | data = "no_columns.csv"
      |        ^~~~~~~~~~~~~~~~
expected: one line of column names with CSR and N, then rows of positive numbers, as 0.15,12
)_"},
SceneMistake{"RatiosInPercent",
    "cycles = 30",
    "data = \"percent.csv\"",
R"_(
test.toml:13:8: error[data]: 'percent.csv': line 2: a CSR of 20 is no ratio of stresses, as 0.15: are the numbers in per cent, or the columns exchanged?
   13 | data = "percent.csv"
      |        ^~~~~~~~~~~~~
expected: one line of column names with CSR and N, then rows of positive numbers, as 0.15,12
)_"},
SceneMistake{"WordsInARow",
    "cycles = 30",
    "data = \"words.csv\"",
R"_(
test.toml:13:8: error[data]: 'words.csv': line 3 is no point: 0.2,many
   13 | data = "words.csv"
      |        ^~~~~~~~~~~
expected: one line of column names with CSR and N, then rows of positive numbers, as 0.15,12
)_"},
SceneMistake{"NoPoints",
    "cycles = 30",
    "data = \"empty.csv\"",
R"_(
test.toml:13:8: error[data]: 'empty.csv': it holds no points
   13 | data = "empty.csv"
      |        ^~~~~~~~~~~
expected: one line of column names with CSR and N, then rows of positive numbers, as 0.15,12
)_"}
), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
