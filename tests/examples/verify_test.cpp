// quicksand verify: its files and its exit code when an error is too large; its numbers: tests/regression.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace testing_program;

TEST(Verify, AnErrorAboveItsLimitIsExitCode6)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("verify biot_waves --short --set 'verification.limits.\"fast wave, speed\"="
                    "[1e-9, 1e-9, 1e-9]' -o " +
                    folder.string());
    EXPECT_EQ(outcome.code, 6) << outcome.output;
    EXPECT_NE(outcome.output.find("MISSED"), std::string::npos) << outcome.output;
    EXPECT_EQ(header_of(folder / "verification.csv"),
              "problem,quantity,norm,cells,error,limit,order,least_order,seconds,reference");
    EXPECT_TRUE(read_file(folder / "biot_waves.png").starts_with("\x89PNG"));
}

TEST(Verify, AProblemThatIsNamedTwiceIsMeasuredOnce)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("verify --short biot_waves biot_waves " +
                                        example("verification/biot_waves") + " -o " + folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    const std::string ended = "biot_waves, 20 cells: ";
    const std::size_t first = outcome.output.find(ended);
    ASSERT_NE(first, std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find(ended, first + 1), std::string::npos) << outcome.output;
}

TEST(Verify, TheScenesRunAsOthersDo)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("run " + example("verification/biot_waves") + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
}

} // namespace
} // namespace quicksand
