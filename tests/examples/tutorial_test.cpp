// The tutorial: its files are those of the example, its commands run, and its numbers are what they give.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>
#include <vector>

namespace quicksand {
namespace {

using namespace testing_program;

struct Block {
    std::string language, text;
};

std::vector<Block> blocks_of(const std::string& document)
{
    std::vector<Block> blocks;
    std::istringstream lines(document);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            if (!inside) blocks.push_back({line.substr(3), ""});
            inside = !inside;
        } else if (inside) {
            blocks.back().text += line + '\n';
        }
    }
    return blocks;
}

/// The last number of a column of a CSV file.
double last_number(const std::filesystem::path& file, const std::string& column)
{
    std::istringstream lines(read_file(file));
    std::string header, last;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) continue;
        (header.empty() ? header : last) = line;
    }
    std::istringstream names(header), cells(last);
    for (std::string name, cell; std::getline(names, name, ',') && std::getline(cells, cell, ',');)
        if (name == column) return std::stod(cell);
    return 0.0;
}

TEST(Tutorial, ItsFilesAreThoseOfTheExampleAndItsCommandsRun)
{
    const std::string document =
        read_file(std::filesystem::path(QUICKSAND_SOURCE_DIR) / "examples/TUTORIAL.md");
    const WorkFolder folder;
    std::filesystem::create_directories(folder / "river_dike");
    int commands = 0;
    for (const Block& block : blocks_of(document)) {
        if (block.language == "geo" || block.language == "toml") {
            const std::string name = block.language == "geo" ? "river_dike.geo" : "scene.toml";
            EXPECT_EQ(block.text, read_file(example("river_dike") + "/" + name)) << name;
            std::ofstream(folder / ("river_dike/" + name)) << block.text;
        }
        if (block.language != "sh") continue;
        ASSERT_TRUE(block.text.starts_with("./qs ")) << block.text;
        const Outcome outcome =
            run_shell("cd " + (folder / "").string() + " && \"$QUICKSAND\" " + block.text.substr(5));
        EXPECT_EQ(outcome.code, 0) << block.text << outcome.output;
        if (block.text.find("stability") != std::string::npos) {
            EXPECT_NE(outcome.output.find("The factor of safety is 2.00"), std::string::npos)
                << outcome.output;
        }
        ++commands;
    }
    EXPECT_EQ(commands, 6);
    EXPECT_NEAR(last_number(folder / "results/river_dike/history.csv", "crest_settlement_m"), 0.52, 0.005);
    EXPECT_TRUE(std::filesystem::exists(folder / "river_dike.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "ground.csv"));
}

} // namespace
} // namespace quicksand
