// A run goes on with another end and other output; what its state hangs on may not change.
#include "io/results/run_record.hpp"
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

class ChangedResume : public testing::Test {
protected:
    Outcome run(const std::string& words) const
    {
        return run_program("run " + example("dike") +
                           " --set grid.cell_size=0.015 --set run.end_time=1e-4 "
                           "--set materials.sand.failure_ratio=0.7410891234 " // more digits than are shown
                           "--threads 1 -o " +
                           results() + ' ' + words);
    }
    std::string results() const { return (folder / "results").string(); }
    /// Settling that ends before the soil is at rest.
    void end_early() const
    {
        const Outcome outcome = run("--set relaxation.max_steps=100");
        ASSERT_EQ(outcome.code, 3) << outcome.output;
        expect(outcome, "the soil does not settle: after 100 steps");
        expect(outcome, "go on with --resume and a larger relaxation.tolerance or more relaxation.max_steps");
        expect(outcome,
               "last checkpoint: " + results() + "/checkpoint/state.h5 (go on from it with --resume)");
    }
    static void expect(const Outcome& outcome, const std::string& text)
    {
        EXPECT_NE(outcome.output.find(text), std::string::npos) << outcome.output;
    }

    WorkFolder folder;
};

TEST_F(ChangedResume, SettlesToALooserTolerance)
{
    end_early();
    const Outcome same = run("--set relaxation.max_steps=100 --resume");
    EXPECT_EQ(same.code, 3) << same.output;
    const Outcome looser = run("--set relaxation.tolerance=0.01 --resume");
    ASSERT_EQ(looser.code, 0) << looser.output;
    expect(looser, "  changed since the run began: relaxation.tolerance: 1e-5 -> 0.01\n"
                   "  changed since the run began: relaxation.max_steps: 100 -> 200000\n");
    expect(looser, "Settled in ");
    const RunRecord record = read_run_record(results() + "/run_manifest.json");
    EXPECT_EQ(record.status, "finished");
    EXPECT_EQ(record.overrides.back(), "relaxation.tolerance=0.01");
}

TEST_F(ChangedResume, IsRefusedToOtherSoil)
{
    end_early();
    const Outcome other = run("--set materials.sand.porosity=0.41 --set relaxation.tolerance=0.01 --resume");
    EXPECT_EQ(other.code, 2) << other.output;
    expect(other, "cannot be resumed, for its state hangs on what has changed since the run began:\n"
                  "  materials.sand.porosity: ");
    EXPECT_EQ(other.output.find("relaxation.tolerance: "), std::string::npos) << other.output;
    EXPECT_EQ(run("--set relaxation.tolerance=0.01 --resume").code, 0);
}

TEST(ResumedColumn, RunsLongerAndWritesAtOtherTimes)
{
    const WorkFolder folder;
    const std::string run = "run " + example("column") + " -o " + (folder / "results").string();
    ASSERT_EQ(run_program(run + " --set run.end_time=2e-3 --set output.history_interval=1e-3").code, 0);
    const Outcome resumed =
        run_program(run + " --set run.end_time=4e-3 --set output.history_interval=5e-4 --resume");
    ASSERT_EQ(resumed.code, 0) << resumed.output;
    const std::string history = read_file(folder / "results/history.csv");
    std::size_t place = 0;
    for (const char* row :
         {"\n0,", "\n0.001,", "\n0.002,", "\n0.0025,", "\n0.003,", "\n0.0035,", "\n0.004,"}) {
        place = history.find(row, place);
        ASSERT_NE(place, std::string::npos) << row << '\n' << history;
    }
}

} // namespace

} // namespace quicksand
