// Boundary conditions and loads that contradict each other, and histories that cannot be read.
#include "tests/messages/io/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneBoundaries : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneBoundaries, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    folder.write("late.csv", "time,factor\n0.5,0\n0.6,1\n");
    folder.write("back.csv", "0,0\n0.2,1\n0.1,2\n");
    folder.write("words.csv", "time,factor\n0,0\nlater,1\n");
    folder.write("good.csv", "0,0\n0.2,1\n");
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneBoundaries, testing::Values(
SceneMistake{"LoadOnAWall",
    "soil = \"fixed\"",
    "soil = \"fixed\"\npressure = \"10 kPa\"",
R"_(
scene.toml:32:1: error[unused-key]: boundaries.base.pressure is not used with soil = "fixed"
   32 | pressure = "10 kPa"
      | ^~~~~~~~
hint: remove it, or set soil = "free"
)_"},
SceneMistake{"TractionOfOneNumber",
    "soil = \"free\"",
    "soil = \"free\"\ntraction = \"10 kPa\"",
R"_(
scene.toml:43:12: error[type]: boundaries.surface.traction is text
   43 | traction = "10 kPa"
      |            ^~~~~~~~
expected: [x, y], two numbers in Pa
)_"},
SceneMistake{"RampOfNothing",
    "soil = \"free\"",
    "soil = \"free\"\nramp_time = \"2 ms\"",
R"_(
scene.toml:43:13: error[boundary]: boundaries.surface.ramp_time has nothing to act on
   43 | ramp_time = "2 ms"
      |             ^~~~~~
expected: a pressure or a traction on the same curve
hint: add pressure or traction, or remove the key
)_"},
SceneMistake{"RampAndHistory",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"good.csv\"\nramp_time = \"2 ms\"",
R"_(
scene.toml:45:13: error[boundary]: boundaries.surface.ramp_time and a history file contradict each other
   45 | ramp_time = "2 ms"
      |             ^~~~~~
expected: one of the two
hint: the file holds the whole course
)_"},
SceneMistake{"WaveAndHistory",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"good.csv\"\nfrequency = 5",
R"_(
scene.toml:45:13: error[boundary]: boundaries.surface.frequency and a history file contradict each other
   45 | frequency = 5
      |             ^
expected: one of the two
hint: the file holds the whole course
)_"},
SceneMistake{"HistoryMissing",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"none.csv\"",
R"_(
scene.toml:44:11: error[file]: 'none.csv' does not exist
   44 | history = "none.csv"
      |           ^~~~~~~~~~
hint: the path is relative to the file that names it
)_"},
SceneMistake{"HistoryBeginsLate",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"late.csv\"",
R"_(
scene.toml:44:11: error[history]: 'late.csv': its time starts at 0.5 s, not at 0
   44 | history = "late.csv"
      |           ^~~~~~~~~~
expected: rows `time_s, factor` from time 0 on, at most one header line
)_"},
SceneMistake{"HistoryRunsBack",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"back.csv\"",
R"_(
scene.toml:44:11: error[history]: 'back.csv': its time does not increase at line 3
   44 | history = "back.csv"
      |           ^~~~~~~~~~
expected: rows `time_s, factor` from time 0 on, at most one header line
)_"},
SceneMistake{"HistoryOfWords",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"words.csv\"",
R"_(
scene.toml:44:11: error[history]: 'words.csv': line 3 is not two numbers: later,1
   44 | history = "words.csv"
      |           ^~~~~~~~~~~
expected: rows `time_s, factor` from time 0 on, at most one header line
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
