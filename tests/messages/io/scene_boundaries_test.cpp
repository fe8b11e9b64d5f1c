// Boundary conditions and loads that contradict each other, and histories that cannot be read.
#include "tests/fixtures/scene_mistake.hpp"

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
    folder.write("one.csv", "time,factor\n0,0\n");
    folder.write("good.csv", "0,0\n0.2,1\n");
    folder.write("minutes.csv", "time [min],factor\n0,0\n1,1\n");
    folder.write("pressures.csv", "time_s,pressure (kPa)\n0,0\n1,10\n");
    folder.write("huge.csv", "0,0\n0.1,1\n0.2,1e90\n");
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
SceneMistake{"MovingWithoutAMotion",
    "soil = \"free\"",
    "soil = \"moving\"",
R"_(
scene.toml:41:1: error[boundary]: boundaries.surface moves but does not say how
   41 | [boundaries.surface]
      | ^~~~~~~~~~~~~~~~~~~~
expected: one of velocity, normal_velocity, displacement, normal_displacement
)_"},
SceneMistake{"TwoMotions",
    "soil = \"free\"",
    "soil = \"moving\"\nvelocity = [0, \"-1 mm/s\"]\nnormal_velocity = \"1 mm/s\"",
R"_(
scene.toml:44:19: error[boundary]: boundaries.surface.normal_velocity and velocity contradict each other
   44 | normal_velocity = "1 mm/s"
      |                   ^~~~~~~~
expected: one of velocity, normal_velocity, displacement, normal_displacement
hint: remove one of the two
)_"},
SceneMistake{"DisplacementAtOnce",
    "soil = \"free\"",
    "soil = \"moving\"\nnormal_displacement = \"1 mm\"",
R"_(
scene.toml:43:23: error[boundary]: boundaries.surface.normal_displacement has no course: the curve would jump to it at the start
   43 | normal_displacement = "1 mm"
      |                       ^~~~~~
expected: a ramp_time, a frequency or a history beside it
)_"},
SceneMistake{"MotionOfAFreeCurve",
    "soil = \"free\"",
    "soil = \"free\"\nvelocity = [0, \"-1 mm/s\"]",
R"_(
scene.toml:43:1: error[unused-key]: boundaries.surface.velocity is not used with soil = "free"
   43 | velocity = [0, "-1 mm/s"]
      | ^~~~~~~~
hint: remove it, or set soil = "moving"
)_"},
SceneMistake{"VelocityOfOneNumber",
    "soil = \"free\"",
    "soil = \"moving\"\nvelocity = \"1 mm/s\"",
R"_(
scene.toml:43:12: error[type]: boundaries.surface.velocity is text
   43 | velocity = "1 mm/s"
      |            ^~~~~~~~
expected: [x, y], two numbers in m/s
)_"},
SceneMistake{"HalfARock",
    "soil = \"fixed\"",
    "soil = \"viscous\"\nrock_density = 2400",
R"_(
scene.toml:32:16: error[boundary]: boundaries.base.rock_density is alone: rock_shear_wave_speed and rock_compression_wave_speed are unknown
   32 | rock_density = 2400
      |                ^~~~
expected: all of rock_density, rock_shear_wave_speed, rock_compression_wave_speed, or none
hint: none makes the boundary as stiff as the soil beside it
)_"},
SceneMistake{"RockOfFasterShearWaves",
    "soil = \"fixed\"",
    "soil = \"viscous\"\nrock_density = 2400\nrock_shear_wave_speed = 800\nrock_compression_wave_speed = 700",
R"_(
scene.toml:34:31: error[boundary]: boundaries.base.rock_compression_wave_speed is not larger than the shear wave speed 800 m/s
   34 | rock_compression_wave_speed = 700
      |                               ^~~
expected: a compression wave that is faster than the shear wave
)_"},
SceneMistake{"RockBeyondAWall",
    "soil = \"fixed\"",
    "soil = \"fixed\"\nrock_density = 2400",
R"_(
scene.toml:32:1: error[unused-key]: boundaries.base.rock_density is not used with soil = "fixed"
   32 | rock_density = 2400
      | ^~~~~~~~~~~~
hint: remove it, or set soil = "viscous"
)_"},
SceneMistake{"HeadWithoutItsWord",
    "soil = \"free\"",
    "soil = \"free\"\nhead = 0.5",
R"_(
scene.toml:43:1: error[unused-key]: boundaries.surface.head is not used with water = "drained"
   43 | head = 0.5
      | ^~~~
hint: remove it, or set water = "head"
)_"},
SceneMistake{"HeadWithoutItsHeight",
    "soil = \"free\"",
    "soil = \"free\"\nwater = \"head\"",
R"_(
scene.toml:41:1: error[missing-key]: [boundaries.surface] has no head
   41 | [boundaries.surface]
      | ^~~~~~~~~~~~~~~~~~~~
expected: head [m]: y of the water surface beyond the curve.
)_"},
SceneMistake{"PressureWithoutItsValue",
    "soil = \"free\"",
    "soil = \"free\"\nwater = \"pore_pressure\"",
R"_(
scene.toml:41:1: error[missing-key]: [boundaries.surface] has no pore_pressure
   41 | [boundaries.surface]
      | ^~~~~~~~~~~~~~~~~~~~
expected: pore_pressure [Pa]: Pore pressure along the curve, with its static part; on a free curve the water beyond it presses on the soil besides.
)_"},
SceneMistake{"HeadOnATiedSide",
    "tied_to = \"right\"",
    "tied_to = \"right\"\nwater = \"head\"\nhead = 1",
R"_(
scene.toml:33:1: error[boundary]: boundaries.left is tied and has a prescribed head
   33 | [boundaries.left]
      | ^~~~~~~~~~~~~~~~~
expected: a head on a curve that is not tied
hint: what passes through one of two tied sides comes in at the other
)_"},
SceneMistake{"RampOfNothing",
    "soil = \"free\"",
    "soil = \"free\"\nramp_time = \"2 ms\"",
R"_(
scene.toml:43:13: error[boundary]: boundaries.surface.ramp_time has nothing to act on
   43 | ramp_time = "2 ms"
      |             ^~~~~~
expected: a load, a motion or a head on the same curve
hint: remove the key, or add what varies
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
SceneMistake{"HistoryOfOneRow",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"one.csv\"",
R"_(
scene.toml:44:11: error[history]: 'one.csv': it holds fewer than two rows of two numbers
   44 | history = "one.csv"
      |           ^~~~~~~~~
expected: rows `time_s, factor` from time 0 on, at most one header line
)_"},
SceneMistake{"HistoryBeyondAllLoads",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"huge.csv\"",
R"_(
huge.csv:3:1: error[history]: a factor of 1e90 is beyond all loads
    3 | 0.2,1e90
      | ^
expected: at most 1e12 in amount
)_"},
SceneMistake{"HistoryInMinutes",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"minutes.csv\"",
R"_(
scene.toml:44:11: error[history]: 'minutes.csv': its header says that times are in min
   44 | history = "minutes.csv"
      |           ^~~~~~~~~~~~~
expected: times in s
hint: convert them, and name s in the header
)_"},
SceneMistake{"HistoryOfPressures",
    "soil = \"free\"",
    "soil = \"free\"\npressure = 1e4\nhistory = \"pressures.csv\"",
R"_(
scene.toml:44:11: error[history]: 'pressures.csv': its header says kPa, and its rows are factors on what the curve has in the scene
   44 | history = "pressures.csv"
      |           ^~~~~~~~~~~~~~~
expected: factors, which have no unit
hint: divide the values by that of the scene, and name them factor
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
