// Regions that stages place and remove, as each stage's scene has them.
#include "io/scene/stage_changes.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

const std::vector<std::string> regions = {"sand", "berm", "pit"};

std::vector<SceneReading> read_column_stages(const std::string& stages)
{
    const fixtures::SceneFolder folder;
    folder.write("scene.toml",
                 fixtures::column_scene +
                     "[regions.berm]\nmaterial = \"sand\"\n[regions.pit]\nmaterial = \"sand\"\n" + stages);
    return read_scene_stages(folder.file("scene.toml"), {});
}

std::string stage(const std::string& name, const std::string& keys)
{
    return "[[stages]]\nname = \"" + name + "\"\nkind = \"settle\"\n" + keys;
}

TEST(StagePlacement, RegionsAreEmptyUntilTheyArePlacedAndAfterTheyAreRemoved)
{
    const auto stages =
        read_column_stages(stage("a", "") + stage("b", "place = [\"berm\"]\n") +
                           stage("c", "remove = [\"pit\", \"berm\"]\n") + stage("d", "place = [\"pit\"]\n"));
    const std::vector<std::vector<bool>> absent = {
        {false, true, false}, {false, false, false}, {false, true, true}, {false, true, false}};
    ASSERT_EQ(stages.size(), absent.size());
    for (std::size_t k = 0; k < stages.size(); ++k) {
        EXPECT_EQ(absent_soils(stages[k].keys, regions), absent[k]) << k;
        EXPECT_EQ(stages[k].scene.columns, ColumnsComputed::all) << "particles come and go";
    }
}

TEST(StagePlacement, TheCopyOfAStageStandsAlone)
{
    const auto stages =
        read_column_stages(stage("a", "") + stage("b", "place = [\"berm\"]\n") + stage("c", ""));
    for (const SceneReading& reading : stages) {
        const fixtures::SceneFolder folder;
        folder.write("scene.toml", reading.scene.text);
        const auto copy = read_scene_stages(folder.file("scene.toml"), {});
        ASSERT_EQ(copy.size(), 1U);
        EXPECT_EQ(absent_soils(copy[0].keys, regions), absent_soils(reading.keys, regions));
    }
}

TEST(StagePlacement, ScenesWithoutItComputeOneColumn)
{
    EXPECT_EQ(read_column_stages(stage("a", ""))[0].scene.columns, ColumnsComputed::one);
}

} // namespace
} // namespace quicksand
