// quicksand stress: a row that runs, one that cannot, and rows that nobody has.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace testing_program;

TEST(Stress, ShortRowsGiveATableAPageAndAFigure)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("stress steps/dry-0.5 steps/semi_implicit-2 --random 0 -o " + folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("steps/dry-0.5"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("2 rows: 1 good 1 stopped"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("0 silent failures"), std::string::npos) << outcome.output;
    EXPECT_TRUE(read_file(folder / "stress.png").starts_with("\x89PNG"));
    EXPECT_TRUE(header_of(folder / "stress.csv").starts_with("group,row,end,energy_error"));
    EXPECT_NE(read_file(folder / "stress.md").find("## steps"), std::string::npos);
    // a row that ran well leaves its scene alone, another one its results as well
    EXPECT_TRUE(std::filesystem::exists(folder / "steps/dry-0.5/scene.toml"));
    EXPECT_FALSE(std::filesystem::exists(folder / "steps/dry-0.5/results"));
    EXPECT_TRUE(std::filesystem::exists(folder / "steps/semi_implicit-2/results/history.csv"));
    EXPECT_NE(read_file(folder / "steps/semi_implicit-2/messages.txt").find("the steps have made energy"),
              std::string::npos);
}

TEST(Stress, ARandomSceneRunsAgainByHand)
{
    const WorkFolder folder;
    const std::string row = "random/1-0005-explicit";
    const Outcome first = run_program("stress --random 5 --row " + row + " -o " + folder.string());
    const Outcome again =
        run_program("run " + (folder / row).string() + " --threads 1 -o " + (folder / "again").string());
    EXPECT_EQ(again.code, first.code) << first.output << again.output;
    EXPECT_EQ(read_file(folder / "again/history.csv"), read_file(folder / (row + "/results/history.csv")));
}

// Random scenes that failed once: water in a single row of cells below dry soil or undrained, with slopes of
// the pressure across the row; implicit steps after a sudden pressure, or with explicit ones in their place.
TEST(Stress, RandomScenesThatFailedOnceKeepTheirEnergy)
{
    for (const std::string rows : {"random/1-0103 random/1-0111 random/1-0122 random/1-0499 --seed 1",
                                   "random/31337-0396 --seed 31337"}) {
        const WorkFolder folder;
        const Outcome outcome = run_program("stress --random 499 -o " + folder.string() + " " + rows);
        EXPECT_EQ(outcome.code, 0) << outcome.output;
        EXPECT_NE(outcome.output.find("0 silent failures"), std::string::npos) << outcome.output;
        for (const std::string end : {" bad", " stopped", " crashed", " overtime"})
            EXPECT_EQ(outcome.output.find(end), std::string::npos) << outcome.output;
    }
}

TEST(Stress, ARowThatTakesTooLongIsEnded)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("stress steps/explicit-0.5 --random 0 --limit 0.02 -o " + folder.string());
    EXPECT_NE(outcome.output.find("ended after 0 s of wall time"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("1 rows: 1 overtime"), std::string::npos) << outcome.output;
}

} // namespace
} // namespace quicksand
