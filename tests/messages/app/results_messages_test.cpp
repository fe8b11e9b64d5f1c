// What picture, figures and probe say when the results do not have what is asked for.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

/// A folder with the results of a few steps of the column in out/.
class Results : public testing::Test {
protected:
    void SetUp() override
    {
        const Outcome run = run_program("run " + example("column") + " --until 5e-6 -o " + results);
        ASSERT_EQ(run.code, 0) << run.output;
    }
    void expect_refusal(const std::string& arguments, const std::string& text, int code = 2) const
    {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.code, code) << arguments << '\n' << outcome.output;
        EXPECT_NE(outcome.output.find(text), std::string::npos) << "no '" << text << "' in:\n"
                                                                << outcome.output;
    }

    WorkFolder folder;
    const std::string results = (folder / "out").string();
};

TEST_F(Results, AreDrawnInFieldsThatTheyHave)
{
    expect_refusal("picture " + results + " --field ruu",
                   "there is no field 'ruu' in the results; did you mean 'ru'? Available: ");
    expect_refusal("picture " + results + " --field ru -o /proc/quicksand/ru.png",
                   "/proc/quicksand: cannot make the folder: No such file or directory", 4);
    expect_refusal("picture " + results + " -o " + (folder / "a.png").string(),
                   "a.png is one file, and the default set has several: name a folder, or one --field");
}

TEST_F(Results, AreDrawnInARangeOfOneField)
{
    expect_refusal("picture " + results + " --field ru --range 1",
                   "'1' is no range: write two numbers in SI units with a colon between, as in 0:9e3");
    expect_refusal("picture " + results + " --field ru --range 1:0",
                   "the range 1:0 is empty: its first value must be the smaller one");
    expect_refusal("picture " + results + " --range 0:1", "--range is for one field: name it with --field");
}

TEST_F(Results, HaveTheFiguresThatTheSceneAsksFor)
{
    const std::string tables =
        " asks for no figures\nexpected: tables [figures.NAME]\nhint: quicksand picture draws "
        "the usual set without them";
    expect_refusal("figures " + results, "the scene " + results + "/scene.toml" + tables);
    expect_refusal("figures " + example("column") + " --results " + results,
                   "the scene " + example("column") + "/scene.toml" + tables);
    expect_refusal("figures " + example("column") + " --results " + results + "/none",
                   "there are no results in " + results + "/none\nhint: quicksand run " + example("column") +
                       " makes them; --results names another folder");
}

TEST_F(Results, HaveHistoriesOfTheirFieldsInTheirSoil)
{
    const std::string probe = "probe " + results + " -o " + (folder / "a.csv").string();
    expect_refusal(probe + " --at 0.01,0.1 --fields ruu",
                   "there is no field 'ruu' in the results; did you mean 'ru'?");
    expect_refusal(probe + " --at 5,0.1 --fields ru",
                   "the point (5, 0.1) m is never inside the soil, which reaches from (0, 0) to ");
    expect_refusal(probe + " --at 0.01,0.1 --fields ru --kind rider",
                   "--kind: rider not in {fixed,material}");
    expect_refusal("probe " + results + " --at 0.01,0.1 --fields ru -o " + (folder / "none/a.csv").string(),
                   "none/a.csv: cannot write: No such file or directory", 4);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST_F(Results, AreComparedWithOthersOfTheirKind)
{
    const std::string other = (folder / "other").string(), out = " -o " + (folder / "compare").string();
    ASSERT_EQ(run_program("run " + example("column") + " --until 5e-6 --set initial.k0=0.6 -o " + other).code,
              0);
    expect_refusal("compare " + results + " " + results + "/" + out, "/out/ is named twice: nothing differs");
    expect_refusal("compare " + results + " " + folder.string() + out,
                   ": neither history.csv nor probes/*.csv\nhint: name the results folder of a run");
    expect_refusal("compare " + results + " " + other + " --field ruu" + out,
                   "there is no field 'ruu' in the results. Available: ");
    const Outcome good = run_program("compare " + results + " " + other + out);
    ASSERT_EQ(good.code, 0) << good.output;
    EXPECT_NE(good.output.find("history: crest_settlement_m\n  out "), std::string::npos) << good.output;
    EXPECT_NE(good.output.find("/compare/difference_excess_pore_pressure.png\n"), std::string::npos)
        << good.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "compare/compare.csv"));

    const std::string coarse = (folder / "coarse").string();
    ASSERT_EQ(run_program("run " + example("column") +
                          " --until 5e-6 --set 'sampling.particles_per_cell=[2,2]' -o " + coarse)
                  .code,
              0);
    const Outcome unlike = run_program("compare " + results + " " + coarse + out);
    EXPECT_EQ(unlike.code, 0) << unlike.output;
    EXPECT_NE(
        unlike.output.find("the difference of the frames is not drawn: their particles do not start at the "
                           "same places"),
        std::string::npos)
        << unlike.output;
    const Outcome own = run_program("compare " + results + " " + other + " -o " + results);
    EXPECT_EQ(own.code, 2) << own.output;
    EXPECT_NE(own.output.find("holds files, but no compare.txt of a former call"), std::string::npos);
}

/// Changes a row of the history that the run has written, as steps that lose water would.
TEST(Run, EndsBadlyWhereItsBalancesDoNotClose)
{
    const WorkFolder folder;
    const std::string results = (folder / "out").string();
    const std::string command =
        "run " + example("column") + " --set output.history_interval=1e-6 -o " + results;
    const Outcome good = run_program(command + " --until 4e-6");
    ASSERT_EQ(good.code, 0) << good.output;
    EXPECT_NE(good.output.find("Verdict: good; largest energy error "), std::string::npos) << good.output;
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"verdict\": \"good\""), std::string::npos);

    std::string history = read_file(results + "/history.csv");
    const std::size_t last_comma = history.rfind(',');
    history.replace(last_comma + 1, history.size() - last_comma - 2, "0.76"); // water_error
    std::ofstream(results + "/history.csv") << history;
    const Outcome bad = run_program(command + " --until 6e-6 --resume");
    EXPECT_EQ(bad.code, 3) << bad.output;
    EXPECT_NE(bad.output.find("the balances of the run do not close, so its results are not to be used:\n"
                              "  water error 0.76 at t = 4e-6 s: water is lost or made by the steps\n"
                              "likely causes: a time step that is too long for the soil (try half of it, "
                              "analysis.step_share), domains that are torn, a start out of equilibrium or "
                              "motion above the frequencies that the cells resolve (quicksand check tells "
                              "both)"),
              std::string::npos)
        << bad.output;
    const std::string manifest = read_file(results + "/run_manifest.json");
    EXPECT_NE(manifest.find("\"verdict\": \"bad\""), std::string::npos) << manifest;
    EXPECT_NE(manifest.find("\"status\": \"failed\""), std::string::npos) << manifest;
}

} // namespace

} // namespace quicksand
