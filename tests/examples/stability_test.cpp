// quicksand stability: the factor of a slope, its files, and scenes that have none.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

TEST(Stability, FindsAFactorAndShowsHowTheSlopeFails)
{
    const WorkFolder folder;
    const std::string command = "stability " + example("verification/griffiths_lane") +
                                " --set grid.cell_size=2 --tolerance 0.1 -o " + folder.string() + "/out";
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("The factor of safety is 1."), std::string::npos) << outcome.output;
    EXPECT_EQ(header_of(folder / "out/stability.csv"), "factor,displacement_m,out_of_balance,stands,steps");
    EXPECT_TRUE(std::filesystem::exists(folder / "out/fields.pvd"));
    EXPECT_NE(read_file(folder / "out/stability.txt").find("fails"), std::string::npos);
    EXPECT_EQ(run_program(command).code, 0) << "a former search is replaced";
}

TEST(Stability, OfASlopeThatStandsLeavesNoFormerFailure)
{
    const WorkFolder folder;
    const std::string command = "stability " + example("verification/griffiths_lane") +
                                " --set grid.cell_size=2 --tolerance 0.1 -o " + folder.string() + "/out";
    ASSERT_EQ(run_program(command).code, 0);
    ASSERT_TRUE(std::filesystem::exists(folder / "out/grid.pvd"));
    const Outcome outcome = run_program(command + " --set 'materials.soil.cohesion=\"1e7 Pa\"'");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("The factor of safety is more than 32: the slope still stands."),
              std::string::npos)
        << outcome.output;
    for (const char* gone : {"fields.pvd", "fields", "grid.pvd", "grid"})
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / gone)) << gone;
}

TEST(Stability, RefusesASceneWithoutStrength)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("stability " + example("verification/terzaghi") + " -o " + folder.string() + "/out");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.output.find("no soil of this scene has a strength to reduce\nexpected: a material with "
                                  "model = \"mohr_coulomb\" or \"ubcsand\""),
              std::string::npos)
        << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

} // namespace

} // namespace quicksand
