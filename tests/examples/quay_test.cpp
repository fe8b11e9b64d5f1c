// A quay whose wall lies on grid lines drains for a minute: slivers of sand get into the wall's cells at
// once.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace quicksand {

namespace {

using namespace testing_program;

TEST(Quay, ConsolidatesInLongSteps)
{
    const WorkFolder folder;
    for (const char* file : {"scene.toml", "sheet_pile.geo"})
        std::filesystem::copy(std::filesystem::path(example("sheet_pile")) / file, folder / file);
    std::ofstream(folder / "drains.toml") << R"(scene_version = 1
base = "scene.toml"
without = ["motion", "run.end_time"]
[[stages]]
name = "ground_water"
kind = "seepage"
[[stages]]
name = "minute"
kind = "consolidate"
duration = "60 s"
)";
    const Outcome outcome = run_program("run " + (folder / "drains.toml").string() + " --threads 1 -o " +
                                        (folder / "out").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    std::string last; // of the rows time, step, ...
    std::ifstream steps(folder / "out/minute/steps.csv");
    for (std::string line; std::getline(steps, line);) last = line;
    EXPECT_LT(std::stoi(last.substr(last.find(',') + 1)), 300) << last; // 112, with waves thousands
}

} // namespace

} // namespace quicksand
