// A stage of consolidation that begins while the ground still moves says so.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace quicksand {
namespace {

using namespace testing_program;

TEST(MovingGround, IsToldOfWhereItIsToConsolidate)
{
    const WorkFolder folder;
    std::filesystem::copy(in_checkout("examples/column"), folder / "column");
    const std::string drain = "[[stages]]\nname = \"drain\"\nkind = \"consolidate\"\nduration = \"5 ms\"\n";
    std::ofstream(folder / "column/staged.toml")
        << "scene_version = 1\nbase = \"scene.toml\"\n[[stages]]\nname = \"gravity\"\nkind = \"settle\"\n"
        << drain
        << "[[stages]]\nname = \"shaking\"\nkind = \"shake\"\nduration = \"4 ms\"\n[[stages]]\nname = "
           "\"after\"\nkind = \"consolidate\"\nduration = \"5 ms\"\n";
    const Outcome outcome =
        run_program("run " + (folder / "column/staged.toml").string() + " -o " + (folder / "a").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    const std::string said = "m/s where this stage of consolidation begins, whose steps do not follow that\n"
                             "hint: let the stage of shaking before it go on until the ground rests";
    const std::size_t told = outcome.output.find(said);
    EXPECT_NE(told, std::string::npos) << outcome.output;
    EXPECT_GT(told, outcome.output.find("Stage 4 of 4")) << outcome.output; // not in the second one
}

} // namespace
} // namespace quicksand
