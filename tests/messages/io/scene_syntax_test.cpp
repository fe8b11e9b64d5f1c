// Texts that are no TOML.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneSyntax : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneSyntax, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneSyntax, testing::Values(
SceneMistake{"DuplicateKey",
    "poisson_ratio = 0.3",
    "poisson_ratio = 0.3\npoisson_ratio = 0.25",
R"_(
scene.toml:23:17: error[duplicate-key]: 'poisson_ratio' is given twice
   23 | poisson_ratio = 0.25
      |                 ^
hint: keep one of the two
)_"},
SceneMistake{"DuplicateTable",
    "[gravity]",
    "[grid]",
R"_(
scene.toml:13:1: error[duplicate-key]: 'grid' is given twice
   13 | [grid]
      | ^
hint: keep one of the two
)_"},
SceneMistake{"UnclosedText",
    "title = \"column\"",
    "title = \"column",
R"_(
scene.toml:2:16: error[syntax]: unescaped control characters other than TAB (U+0009) are explicitly prohibited
    2 | title = "column
      |                ^
hint: is a closing quote missing on this line?
)_"},
SceneMistake{"UnitWithoutQuotes",
    "end_time = 0.2",
    "end_time = 200 ms",
R"_(
scene.toml:50:16: error[syntax]: expected a comment or whitespace, saw 'm'
   50 | end_time = 200 ms
      |                ^
hint: a quantity with a unit stands in quotes: "60 kPa"
)_"},
SceneMistake{"DecimalComma",
    "end_time = 0.2",
    "end_time = 0,2",
R"_(
scene.toml:50:13: error[syntax]: expected a comment or whitespace, saw ','
   50 | end_time = 0,2
      |             ^
hint: the decimal mark is a point: 1.5
)_"},
SceneMistake{"WordWithoutQuotes",
    "kind = \"sine\"",
    "kind = sine",
R"_(
scene.toml:45:8: error[syntax]: could not determine value type
   45 | kind = sine
      |        ^
hint: text stands in quotes: "sand"
)_"},
SceneMistake{"NoEqualsSign",
    "end_time = 0.2",
    "end_time 0.2",
R"_(
scene.toml:50:10: error[syntax]: expected '=', saw '0'
   50 | end_time 0.2
      |          ^
hint: a line is `key = value`, `[table]` or `# comment`
)_"},
SceneMistake{"NoDigitAfterThePoint",
    "end_time = 0.2",
    "end_time = 0.",
R"_(
scene.toml:50:14: error[syntax]: expected decimal digit, saw '\n'
   50 | end_time = 0.
      |              ^
hint: write a digit on both sides of the point: 0.5
)_"},
SceneMistake{"NoValue",
    "end_time = 0.2",
    "end_time =",
R"_(
scene.toml:50:11: error[syntax]: expected value, saw '\n'
   50 | end_time =
      |           ^
hint: give the key a value, or put # before the line
)_"},
SceneMistake{"LoneBracket",
    "title = \"column\"",
    "[",
R"_(
scene.toml:2:1: error[syntax]: this line is not complete
    2 | [
      | ^
hint: a line is `key = value`, `[table]` or `# comment`
)_"},
SceneMistake{"TypographicQuotes",
    "title = \"column\"",
    "title = “column”",
R"_(
scene.toml:2:9: error[syntax]: the character '“' is allowed in quotes and comments only
    2 | title = “column”
      |         ^
hint: typographic quotes are no quotes here: use "
scene.toml:2:16: error[syntax]: the character '”' is allowed in quotes and comments only
    2 | title = “column”
      |                ^
hint: typographic quotes are no quotes here: use "
)_"},
SceneMistake{"MinusSignOfTypography",
    "level = 0.3175",
    "level = −0.3",
R"_(
scene.toml:17:9: error[syntax]: the character '−' is allowed in quotes and comments only
   17 | level = −0.3
      |         ^
hint: use the plain minus sign -
)_"},
SceneMistake{"SpaceWithoutBreak",
    "level = 0.3175",
    "level =\u00a00.3",
"\n"
"scene.toml:17:8: error[syntax]: the character '\u00a0' is allowed in quotes and comments only\n"
"   17 | level =\u00a00.3\n"
"      |        ^\n"
"hint: use a plain space\n"},
SceneMistake{"UmlautInAKey",
    "level = 0.3175",
    "lövel = 0.3",
R"_(
scene.toml:17:2: error[syntax]: the character 'ö' is allowed in quotes and comments only
   17 | lövel = 0.3
      |  ^
hint: put names with such characters in quotes
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
