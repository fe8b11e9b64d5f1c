// Rows of the stability laboratory that do not exist.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace testing_program;

TEST(Stress, AnUnknownRowListsTheGroups)
{
    const WorkFolder folder;
    for (const std::string words : {"stress stepps", "stress --row steps/dry-0.51"}) {
        const Outcome outcome = run_program(words + " -o " + folder.string());
        EXPECT_EQ(outcome.code, 2) << outcome.output;
        EXPECT_NE(outcome.output.find("no row of the laboratory begins with 'step"), std::string::npos)
            << outcome.output;
        EXPECT_NE(outcome.output.find("expected: steps, interpolations, conductivity"), std::string::npos)
            << outcome.output;
    }
}

} // namespace
} // namespace quicksand
