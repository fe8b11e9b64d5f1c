#include "io/sweeps/sweep_outcomes.hpp"
#include "io/sweeps/sweep_runs.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/checkout.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

namespace {

VariedKey listed(const std::string& key, const std::vector<std::string>& values)
{
    return {key, values, std::nullopt, {}};
}

Sweep sweep_of_column(std::vector<VariedKey> varied)
{
    Sweep sweep;
    sweep.file = "sweep.toml";
    sweep.scene = in_checkout("examples/column/scene.toml");
    sweep.fixed = {"run.end_time=0.1"};
    sweep.varied = std::move(varied);
    return sweep;
}

/// What the runs replace besides the fixed key.
std::vector<std::string> last_words(const Sweep& sweep)
{
    std::vector<std::string> words;
    for (const SweepRun& run : runs_of(sweep)) words.push_back(run.overrides.back());
    return words;
}

} // namespace

TEST(SweepRuns, AreTheProductOfTheLists)
{
    const std::vector<SweepRun> runs =
        runs_of(sweep_of_column({listed("a", {"1", "2"}), listed("b", {"\"x\"", "\"y\"", "\"z\""})}));
    ASSERT_EQ(runs.size(), 6U);
    EXPECT_EQ(runs[0].overrides, (std::vector<std::string>{"run.end_time=0.1", "a=1", "b=\"x\""}));
    EXPECT_EQ(runs[2].overrides.back(), "b=\"z\"");
    EXPECT_EQ(runs[3].overrides, (std::vector<std::string>{"run.end_time=0.1", "a=2", "b=\"x\""}));
    EXPECT_EQ(runs[5].folder, "run_0006");
    EXPECT_EQ(runs[5].number, 6);
}

TEST(SweepRuns, DrawEveryRandomKeyInEachSample)
{
    VariedKey random{"b", {}, Distribution{DistributionKind::uniform, 0.0, 0.0, 1.0, 2.0, "g"}, {}};
    Sweep sweep = sweep_of_column({listed("a", {"1", "2"}), random});
    sweep.samples = 3;
    const std::vector<std::string> words = last_words(sweep);
    ASSERT_EQ(words.size(), 6U);
    EXPECT_EQ(words[0], words[3]) << "the same samples for each combination of the lists";
    EXPECT_NE(words[0], words[1]);
    EXPECT_TRUE(words[0].starts_with("b=\"1.") && words[0].ends_with(" g\"")) << words[0];
    sweep.seed = 2;
    EXPECT_NE(words, last_words(sweep));
}

TEST(SweepRuns, KnowTheirValuesInSi)
{
    const std::vector<CheckedRun> runs = check_runs(sweep_of_column(
        {listed("motion.amplitude", {"\"1 g\""}), listed("analysis.scheme", {"\"explicit\""})}));
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].values[0].number, 9.81);
    EXPECT_EQ(runs[0].values[0].unit, "m/s2");
    EXPECT_EQ(runs[0].values[1].text, "explicit");
    EXPECT_TRUE(std::isnan(runs[0].values[1].number));
}

TEST(SweepRuns, AreRefusedAllAtOnce)
{
    const Sweep sweep = sweep_of_column({listed("motion.amplitude", {"1", "\"1 kg\"", "\"x\""}),
                                         listed("materials.sand.porosity", {"0.4", "0.41"})});
    try {
        check_runs(sweep);
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(
                      "sweep.toml: runs 3, 4 cannot be run:\n--set 'motion.amplitude=\"1 kg\"': error[unit]"),
                  std::string::npos)
            << message;
        EXPECT_NE(
            message.find("sweep.toml: runs 5, 6 cannot be run:\n--set 'motion.amplitude=\"x\"': error[type]"),
            std::string::npos)
            << message;
    }
}

TEST(SweepOutcomes, AreReadFromManifests)
{
    const fixtures::TemporaryFolder folder;
    const std::vector<CheckedRun> runs =
        check_runs(sweep_of_column({listed("motion.amplitude", {"1", "2", "3"})}));
    for (int k = 0; k < 2; ++k)
        std::filesystem::create_directories(folder / runs[static_cast<std::size_t>(k)].run.folder);
    std::ofstream(folder / "run_0001/run_manifest.json")
        << R"({"status": "finished", "verdict": "good", "scene_hash": ")" << runs[0].hash
        << R"(", "wall_time_s": 2.5, "summary": {"history": {"max_ru": {"peak": 0.9, "peak_time_s": 1.0, "final": 0.5}},
             "P": {"ux_m": {"peak": -3.0, "peak_time_s": 1.0, "final": 0.0}}, "last_frame": {"time_s": 1.0}}})";
    std::ofstream(folder / "run_0002/run_manifest.json") << R"({"status": "finished", "scene_hash": "0"})";
    const std::vector<SweepOutcome> outcomes = read_outcomes(runs, folder.path());
    EXPECT_EQ(outcomes[0].state, "finished");
    EXPECT_EQ(outcomes[1].state, "other");
    EXPECT_EQ(outcomes[2].state, "missing");
    EXPECT_EQ(quantities_of(outcomes), (std::vector<std::string>{"max_ru", "P.ux_m"}));
    EXPECT_EQ(value_of(outcomes[0], "max_ru"), 0.9);
    EXPECT_EQ(value_of(outcomes[0], "max_ru_final"), 0.5);
    EXPECT_EQ(value_of(outcomes[0], "P.ux_m_peak"), -3.0);
    EXPECT_TRUE(std::isnan(value_of(outcomes[2], "max_ru")));

    write_sweep_csv(folder / "sweep.csv", sweep_of_column({listed("motion.amplitude", {"1", "2", "3"})}),
                    outcomes);
    std::ifstream stream(folder / "sweep.csv");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(
        text.find("\nrun,folder,motion.amplitude_m_s2,state,verdict,wall_time_s,max_ru_peak,max_ru_final,"
                  "P.ux_m_peak,P.ux_m_final,reason\n"
                  "1,run_0001,1,finished,good,2.5,0.9,0.5,-3,0,\n"
                  "2,run_0002,2,other,,,,,,,\n"
                  "3,run_0003,3,missing,,,,,,,\n"),
        std::string::npos)
        << text;
}

} // namespace quicksand
