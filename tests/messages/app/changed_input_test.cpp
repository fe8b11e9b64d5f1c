// A run goes on with the drawing that it began with, or not at all.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

TEST(Resume, RefusesADrawingThatHasChanged)
{
    const WorkFolder folder;
    std::filesystem::copy(example("column"), folder / "column");
    const std::string run = "run " + (folder / "column").string() + " -o " + (folder / "results").string();
    ASSERT_EQ(run_program(run + " --until 5e-6").code, 0);
    const Outcome unchanged = run_program(run + " --until 1e-5 --resume");
    ASSERT_EQ(unchanged.code, 0) << unchanged.output;

    std::ofstream(folder / "column/column.geo", std::ios::app) << "// edited\n";
    const Outcome outcome = run_program(run + " --until 2e-5 --resume");
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find("column.geo: the file has changed since the run began (geometry.file"),
              std::string::npos)
        << outcome.output;
    EXPECT_EQ(run_program(run + " --until 1e-5 --overwrite").code, 0);
}

} // namespace

} // namespace quicksand
