// What rows are found to be from their files, and what the laboratory counts and writes of them.
#include "app/stress/rows/row_numbers.hpp"
#include "app/stress/rows/stress_report.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::TemporaryFolder;
using fixtures::text_of;

RowOutcome outcome_of(const std::string& name, RowEnd end, double energy_error)
{
    RowOutcome outcome;
    outcome.row.group = "steps";
    outcome.row.name = name;
    outcome.end = end;
    outcome.energy_error = energy_error;
    outcome.last_energy_error = energy_error;
    outcome.displacement = 1.0;
    return outcome;
}

/// A row's folder with a history of two rows and messages.
RowOutcome outcome_of_files(const std::string& last_energy_error, const std::string& messages,
                            const ProcessEnd& process)
{
    const TemporaryFolder folder;
    StressRow row;
    row.group = "steps";
    row.name = "one";
    const RowFiles files = files_of(folder.path(), row);
    std::filesystem::create_directories(files.results());
    std::ofstream(files.results() / "history.csv")
        << "# words\ntime_s,max_velocity_m_s,max_displacement_m,energy_error,water_error,momentum_x_N_s,"
           "momentum_error_x_N_s\n0,0,0,0,0,0,0\n1,2,0.5,"
        << last_energy_error << ",-0.002,4,1\n";
    std::ofstream(files.complaints()) << messages;
    return read_outcome(row, files, process);
}

TEST(RowOutcome, TellsTheLargestErrorsOfAHistory)
{
    const RowOutcome outcome = outcome_of_files("-0.02", "", {0, false, 1.5});
    EXPECT_EQ(outcome.end, RowEnd::usable);
    EXPECT_DOUBLE_EQ(outcome.energy_error, 0.02);
    EXPECT_DOUBLE_EQ(outcome.water_error, 0.002);
    EXPECT_DOUBLE_EQ(outcome.momentum_error, 0.25);
    EXPECT_DOUBLE_EQ(outcome.velocity, 2.0);
    EXPECT_TRUE(std::isnan(outcome.loss));
    EXPECT_DOUBLE_EQ(outcome.displacement, 0.5);
    EXPECT_DOUBLE_EQ(outcome.seconds, 1.5);
    EXPECT_EQ(outcome.reason, "");
    EXPECT_EQ(outcome.bad_file, "");
}

TEST(RowOutcome, TheLossIsThatOverTheEnergyAtTheStartAndTheWorksFromOutside)
{
    const TemporaryFolder folder;
    StressRow row;
    const RowFiles files = files_of(folder.path(), row);
    std::filesystem::create_directories(files.results());
    std::ofstream(files.results() / "history.csv")
        << "time_s,kinetic_energy_J,numerical_loss_J,gravity_work_J,base_work_J,boundary_work_J\n"
           "0,1,0,0,0,0\n1,9,-30,2,0,-3\n";
    EXPECT_DOUBLE_EQ(read_outcome(row, files, {}).loss, 5.0);
}

TEST(RowOutcome, ARunThatFailedTellsWhyAndWhere)
{
    const RowOutcome outcome = outcome_of_files(
        "0",
        "scene.toml: warning[size]: words\nthe run failed in step 3: it broke\n  particle 1 at (2, 3) m\n",
        {3, false, 1.0});
    EXPECT_EQ(outcome.end, RowEnd::stopped);
    EXPECT_EQ(outcome.reason, "the run failed in step 3: it broke; particle 1 at (2, 3) m");
}

TEST(RowOutcome, ABadVerdictIsToldFromAFailure)
{
    const RowOutcome outcome = outcome_of_files(
        "0.5", "the balances of the run do not close, so its results are not to be used:\n  energy\n",
        {3, false, 1.0});
    EXPECT_EQ(outcome.end, RowEnd::bad);
}

TEST(RowOutcome, RefusalsCrashesAndLateRunsAreToldApart)
{
    const RowOutcome refused = outcome_of_files("0", "scene.toml:1:2: error[key]: no\n", {2, false, 1.0});
    EXPECT_EQ(refused.end, RowEnd::refused);
    EXPECT_EQ(refused.reason, "scene.toml:1:2: error[key]: no");
    const RowOutcome crashed = outcome_of_files("0", "", {-6, false, 1.0});
    EXPECT_EQ(crashed.end, RowEnd::crashed);
    EXPECT_EQ(crashed.reason, "signal 6: ");
    const RowOutcome late = outcome_of_files("0", "", {-9, true, 60.0});
    EXPECT_EQ(late.end, RowEnd::overtime);
    EXPECT_EQ(late.reason, "ended after 60 s of wall time");
}

TEST(RowOutcome, ANumberThatIsNoneIsFoundInTheHistory)
{
    EXPECT_EQ(outcome_of_files("inf", "", {0, false, 1.0}).bad_file, "history.csv, energy_error");
    EXPECT_EQ(outcome_of_files("", "", {0, false, 1.0}).bad_file, "history.csv, energy_error");
}

TEST(StressSummary, AGoodExitWithABadBalanceIsASilentFailure)
{
    EXPECT_TRUE(is_silent(outcome_of("a", RowEnd::usable, 0.11)));
    EXPECT_FALSE(is_silent(outcome_of("a", RowEnd::usable, 0.09)));
    EXPECT_FALSE(is_silent(outcome_of("a", RowEnd::bad, 0.11)));
    RowOutcome churning = outcome_of("a", RowEnd::usable, 0.01);
    churning.loss = 3.0;
    EXPECT_TRUE(is_silent(churning));
    RowOutcome wet = outcome_of("a", RowEnd::good, 0.0);
    wet.water_error = 0.011;
    EXPECT_TRUE(is_silent(wet));
}

TEST(StressSummary, CountsWhatIsNotAsItShouldBe)
{
    std::vector<RowOutcome> outcomes = {
        outcome_of("well", RowEnd::good, 0.0),       outcome_of("silent", RowEnd::good, 0.5),
        outcome_of("stopped", RowEnd::stopped, 0.0), outcome_of("beyond", RowEnd::stopped, 0.0),
        outcome_of("refused", RowEnd::refused, 0.0), outcome_of("twin", RowEnd::good, 0.0)};
    outcomes[3].row.step_factor = 1.5; // nobody promises that this runs
    outcomes[0].margin = 1.2;
    outcomes[2].margin = 0.9;
    outcomes[0].row.most_velocity = 1e-4;
    outcomes[0].velocity = 1e-3;
    outcomes[5].row.twin = "well";
    outcomes[5].displacement = 0.9;
    outcomes[5].halvings = 2.0;
    compare_twins(outcomes);
    const StressSummary summary = summarize(outcomes);
    EXPECT_EQ(summary.rows, 6u);
    EXPECT_EQ(summary.ends[static_cast<std::size_t>(RowEnd::good)], 3u);
    EXPECT_EQ(summary.silent,
              std::vector<std::string>{
                  "steps/silent: energy error 0.5 (0.5 at the end), loss nan, water error nan"});
    EXPECT_EQ(summary.failures, std::vector<std::string>{"steps/stopped: stopped: "});
    EXPECT_EQ(summary.poor_margins, std::vector<std::string>{"steps/stopped: 0.9"});
    EXPECT_EQ(summary.too_fast, std::vector<std::string>{"steps/well: 0.001 m/s, at most 0.0001"});
    EXPECT_EQ(summary.halved, std::vector<std::string>{"steps/twin: 2 times"});
    EXPECT_EQ(summary.disagreeing, std::vector<std::string>{"steps/twin: 10 % from well"});
}

TEST(StressReport, APageAndATableHaveEveryRow)
{
    const TemporaryFolder folder;
    const std::vector<RowOutcome> outcomes = {outcome_of("well", RowEnd::good, 0.001),
                                              outcome_of("silent", RowEnd::good, 0.5)};
    write_stress_csv(folder / "stress.csv", outcomes);
    const std::string table = text_of(folder / "stress.csv");
    EXPECT_NE(table.find("group,row,end,energy_error,last_energy_error,numerical_loss,water_error,momentum_"
                         "error,checkerboard,"
                         "largest_velocity_m_s,step_margin,disagreement,step_halvings,seconds,remark\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("steps,silent,good,0.5,0.5,,,,,,,,,0,\"SILENT FAILURE\"\n"), std::string::npos)
        << table;
    write_stress_page(folder / "stress.md", outcomes, {folder / "stress.png"});
    const std::string page = text_of(folder / "stress.md");
    EXPECT_NE(page.find("1 silent failures"), std::string::npos) << page;
    EXPECT_NE(page.find("![stress](stress.png)"), std::string::npos) << page;
    EXPECT_NE(page.find("| silent | good | 0.5 |"), std::string::npos) << page;
}

} // namespace
} // namespace quicksand
