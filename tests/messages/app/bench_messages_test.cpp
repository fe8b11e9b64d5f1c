// A benchmark whose runs go bad is no mistake of the input.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

TEST(Bench, ARunThatGoesBadIsANumericalFailure)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("bench error --set relaxation.max_steps=50 --set relaxation.tolerance=1e-9 " +
                    example("dike") + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    EXPECT_NE(outcome.output.find("does not settle"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("dike: left out: the explicit run to compare with failed"),
              std::string::npos)
        << outcome.output;
}

} // namespace

} // namespace quicksand
