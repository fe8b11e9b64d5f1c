// Mistakes in [verification].
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

const std::string sound = fixtures::replaced(fixtures::column_scene, "[run]\nend_time = 0.2\n", R"([run]
end_time = 0.2

[verification]
problem = "biot_waves"
length = 0.3
cells = [10, 20]
)");

void expect_message(const std::string& line, const std::string& part)
{
    const fixtures::SceneFolder folder;
    const std::string message =
        folder.message(line.starts_with("cells")
                           ? fixtures::replaced(sound, "cells = [10, 20]\n", line)
                           : fixtures::replaced(sound, "cells = [10, 20]\n", "cells = [10, 20]\n" + line));
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(SceneVerification, IsReadWithTheFirstGridAsItsShortOne)
{
    const fixtures::SceneFolder folder;
    const auto verification = folder.read(sound).scene.verification;
    ASSERT_TRUE(verification.has_value());
    EXPECT_EQ(verification->problem, "biot_waves");
    EXPECT_EQ(verification->short_cells, std::vector<int>{10});
    EXPECT_FALSE(folder.read(fixtures::column_scene).scene.verification.has_value());
}

TEST(SceneVerification, AnUnknownProblemIsGuessed)
{
    const fixtures::SceneFolder folder;
    const std::string message = folder.message(fixtures::replaced(sound, "biot_waves", "biot_wave"));
    EXPECT_NE(message.find("error[word]: verification.problem = \"biot_wave\" is not known"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("did you mean \"biot_waves\"?"), std::string::npos) << message;
}

TEST(SceneVerification, WaterFlowsByItself)
{
    const fixtures::SceneFolder folder;
    const std::string message =
        folder.message(fixtures::replaced(sound, "level = 0.3175", "level = 0.3175\nflow = \"drained\""));
    EXPECT_NE(
        message.find("error[verification]: the problems of verify have coupled flow in their solutions, "
                     "not drained"),
        std::string::npos)
        << message;
}

TEST(SceneVerification, CellsAreAListOfCountsThatIncrease)
{
    expect_message("cells = 10\n", "error[type]: verification.cells is a number");
    expect_message("cells = []\n", "expected: a list of whole numbers, as [10, 20, 40]");
    expect_message("cells = [10, 2.5]\n", "verification.cells = 2.5 is not a whole number");
    expect_message("cells = [20, 10]\n", "verification.cells does not go from coarse to fine");
}

TEST(SceneVerification, ShortCellsAreSomeOfTheCells)
{
    expect_message("short_cells = [15]\n", "verification.short_cells has 15, which is not in cells");
}

TEST(SceneVerification, LimitsAreOneForEachGrid)
{
    expect_message("limits = { speed = [0.1] }\n",
                   "error[verification]: the limits of \"speed\" are 1, the grids of verification.cells 2");
    expect_message("limits = { speed = 0.1 }\n", "verification.limits.speed is a number");
    expect_message("limits = { speed = [0.1, -1.0] }\n", "verification.limits.speed");
    expect_message("limits = [0.1]\n", "expected: a table of lists of numbers");
}

TEST(SceneVerification, OneCellNamesParametersOfTheScene)
{
    expect_message("one_cell = [\"width\"]\n", "verification.one_cell names \"width\"");
}

TEST(SceneVerification, OnlyManufacturedMotionsHaveAnAmplitude)
{
    expect_message("amplitude = 0.3\n",
                   "error[unused-key]: verification.amplitude is not used with problem = \"biot_waves\"");
}

TEST(SceneVerification, AFixedNumberOfCellsIsRefused)
{
    const fixtures::SceneFolder folder;
    const std::string message = folder.message(
        fixtures::replaced(sound, "cell_size = \"7.5 mm\"", "cell_size = \"7.5 mm\"\ncells = [9, 52]"));
    EXPECT_NE(message.find("grid.cells fixes the number of cells that verify is to vary"), std::string::npos)
        << message;
}

} // namespace
} // namespace quicksand
