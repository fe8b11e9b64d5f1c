// Mistakes in a sweep's file: the place, what is allowed and the cure.
#include "io/sweeps/sweep_file.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

const std::string sound_sweep = R"(sweep_version = 1
scene = "scene.toml"
set = ["run.end_time=1"]
samples = 3

[vary."motion.amplitude"]
values = ["0.1 g", "0.2 g"]

[vary."materials.sand.porosity"]
distribution = "lognormal"
mean = 0.4
deviation = 0.02

[fragility]
quantity = "crest_settlement_m"
threshold = 0.1
)";

/// What is said of the file; files are named without their folder.
std::string sweep_message(const std::string& text)
{
    const fixtures::TemporaryFolder folder;
    std::ofstream(folder / "scene.toml") << "";
    std::ofstream(folder / "sweep.toml") << text;
    try {
        read_sweep_file(folder / "sweep.toml");
    } catch (const InputError& error) {
        std::string message = error.what();
        const std::string prefix = folder.path().string() + "/";
        for (auto at = message.find(prefix); at != std::string::npos; at = message.find(prefix))
            message.erase(at, prefix.size());
        return message + "\n";
    }
    return "";
}

class SweepMistakes : public testing::TestWithParam<SceneMistake> {};

TEST_P(SweepMistakes, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    EXPECT_EQ(sweep_message(fixtures::replaced(sound_sweep, mistake.sound, mistake.mistaken)),
              mistake.message.substr(1)); // after the line break that opens it
}

TEST(SweepFile, ASoundOneHasNoMessage)
{
    EXPECT_EQ(sweep_message(sound_sweep), "");
}

TEST(SweepFile, AllMistakesAreReportedAtOnce)
{
    std::string text = fixtures::replaced(sound_sweep, "mean = 0.4", "mean = -0.4");
    text = fixtures::replaced(text, "samples = 3", "samples = 0");
    const std::string message = sweep_message(text);
    EXPECT_NE(message.find("sweep.toml:4:11: error[range]"), std::string::npos) << message;
    EXPECT_NE(message.find("sweep.toml:11:8: error[range]"), std::string::npos) << message;
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Files, SweepMistakes, testing::Values(
SceneMistake{"OtherVersion",
    "sweep_version = 1",
    "sweep_version = 2",
R"_(
sweep.toml:1:17: error[version]: sweep_version 2 is not known to this program
    1 | sweep_version = 2
      |                 ^
expected: sweep_version = 1
)_"},
SceneMistake{"NoScene",
    "scene = \"scene.toml\"",
    "scene = \"other.toml\"",
R"_(
sweep.toml:2:9: error[file]: there is no scene 'other.toml'
    2 | scene = "other.toml"
      |         ^~~~~~~~~~~~
expected: a scene, or a folder that holds scene.toml; the path is relative to the sweep's file
)_"},
SceneMistake{"KeyWithoutQuotes",
    "[vary.\"motion.amplitude\"]",
    "[vary.motion.amplitude]",
R"_(
sweep.toml:6:1: error[quotes]: the key of the scene stands without quotes
    6 | [vary.motion.amplitude]
      | ^~~~~~~~~~~~~~~~~~~~~~~
expected: [vary."motion.amplitude"]
)_"},
SceneMistake{"MisspeltKey",
    "deviation = 0.02",
    "devation = 0.02",
R"_(
sweep.toml:12:1: error[unknown-key]: unknown key 'devation' in [vary."materials.sand.porosity"]
   12 | devation = 0.02
      | ^~~~~~~~
expected: one of distribution, mean, deviation
hint: did you mean deviation?
)_"},
SceneMistake{"NoList",
    "values = [\"0.1 g\", \"0.2 g\"]",
    "values = []",
R"_(
sweep.toml:7:10: error[type]: vary."motion.amplitude".values is a list
    7 | values = []
      |          ^~
expected: a list of numbers, texts or lists of them, at least one
)_"},
SceneMistake{"UnknownDistribution",
    "\"lognormal\"",
    "\"weibull\"",
R"_(
sweep.toml:10:16: error[word]: vary."materials.sand.porosity".distribution = "weibull" is not known
   10 | distribution = "weibull"
      |                ^~~~~~~~~
expected: one of list, normal, lognormal, uniform
)_"},
SceneMistake{"NoParameter",
    "deviation = 0.02\n",
    "",
R"_(
sweep.toml:9:1: error[missing-key]: [vary."materials.sand.porosity"] has no deviation
    9 | [vary."materials.sand.porosity"]
      | ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
expected: deviation: Standard deviation of the key itself, of lognormal keys too; in the unit of the mean.
)_"},
SceneMistake{"OtherUnit",
    "deviation = 0.02",
    "deviation = \"2 %\"",
R"_(
sweep.toml:12:13: error[unit]: vary."materials.sand.porosity".deviation has the unit '%'
   12 | deviation = "2 %"
      |             ^~~~~
expected: no unit, as the parameter before it
)_"},
SceneMistake{"NoQuantity",
    "mean = 0.4",
    "mean = \"much\"",
R"_(
sweep.toml:11:8: error[type]: vary."materials.sand.porosity".mean is text
   11 | mean = "much"
      |        ^~~~~~
expected: a number, or a quantity in quotes
)_"},
SceneMistake{"NegativeMean",
    "mean = 0.4",
    "mean = -0.4",
R"_(
sweep.toml:11:8: error[range]: vary."materials.sand.porosity".mean of a lognormal key is not above 0
   11 | mean = -0.4
      |        ^~~~
expected: more than 0
)_"},
SceneMistake{"NoDeviation",
    "deviation = 0.02",
    "deviation = 0",
R"_(
sweep.toml:12:13: error[range]: vary."materials.sand.porosity".deviation is not above 0
   12 | deviation = 0
      |             ^
expected: more than 0
)_"},
SceneMistake{"LimitsTheWrongWayRound",
    "distribution = \"lognormal\"\nmean = 0.4\ndeviation = 0.02",
    "distribution = \"uniform\"\nlow = 0.5\nhigh = 0.4",
R"_(
sweep.toml:12:8: error[range]: vary."materials.sand.porosity".high is not above the lower limit
   12 | high = 0.4
      |        ^~~
)_"},
SceneMistake{"NoSamples",
    "samples = 3\n",
    "",
R"_(
sweep.toml:8:1: error[missing-key]: the key is random, and the sweep has no samples
    8 | [vary."materials.sand.porosity"]
      | ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
expected: samples = 100, above the first table
)_"},
SceneMistake{"SamplesOfNothing",
    "distribution = \"lognormal\"\nmean = 0.4\ndeviation = 0.02",
    "values = [0.4]",
R"_(
sweep.toml:4:11: error[samples]: samples are of no use: no key has a distribution
    4 | samples = 3
      |           ^
expected: distribution = "lognormal" in a table [vary."KEY"]
)_"},
SceneMistake{"TooManyRuns",
    "samples = 3",
    "samples = 60000",
R"_(
sweep.toml:6:1: error[range]: the sweep has 1.2e5 runs
    6 | [vary."motion.amplitude"]
      | ^~~~~~~~~~~~~~~~~~~~~~~~~
expected: at most 1e5
)_"},
SceneMistake{"SetAndVaried",
    "\"run.end_time=1\"",
    "\"motion.amplitude=1\"",
R"_(
sweep.toml:3:7: error[duplicate-key]: set and vary both give motion.amplitude
    3 | set = ["motion.amplitude=1"]
      |       ^~~~~~~~~~~~~~~~~~~~~~
expected: one of the two
)_"},
SceneMistake{"UnknownIntensity",
    "threshold = 0.1",
    "threshold = 0.1\nintensity = \"motion.amplitud\"",
R"_(
sweep.toml:17:13: error[intensity]: "motion.amplitud" is not varied
   17 | intensity = "motion.amplitud"
      |             ^~~~~~~~~~~~~~~~~
expected: one of motion.amplitude, materials.sand.porosity
hint: did you mean "motion.amplitude"?
)_"},
SceneMistake{"NoIntensity",
    "[vary.\"motion.amplitude\"]\nvalues = [\"0.1 g\", \"0.2 g\"]\n",
    "",
R"_(
sweep.toml:12:1: error[intensity]: neither motion.amplitude nor motion.scale is varied, and fragility names no intensity
   12 | [fragility]
      | ^~~~~~~~~~~
expected: materials.sand.porosity
)_"}
), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
