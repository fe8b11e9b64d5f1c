// The designed set: names that tell rows apart, scenes that can be read, sections as they are meant.
#include "app/stress/rows/row_files.hpp"
#include "app/stress/scenes/designed_set.hpp"
#include "app/stress/scenes/section_draft.hpp"
#include "io/scene/scene_file.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <set>

namespace quicksand {
namespace {

TEST(SceneDraft, GivesItsKeysInTheirTables)
{
    SceneDraft scene;
    scene.set("scene_version", 1.0).set("water.level", 1e-8).set("grid.origin", -1.0, 0.5);
    scene.set_whole("grid.cells", 3, 4).set("water.flow", "drained").set("water.level", 2.5);
    scene.set("initial.k0", 0.5).remove("initial").remove("water.flow");
    EXPECT_EQ(scene.text("words"), "# words\nscene_version = 1\n\n[water]\nlevel = 2.5\n\n[grid]\n"
                                   "origin = [-1, 0.5]\ncells = [3, 4]\n");
    EXPECT_TRUE(scene.has("water.level"));
    EXPECT_FALSE(scene.has("water.flow"));
}

TEST(SectionDraft, RegionsSideBySideShareTheLineBetweenThem)
{
    SectionDraft section;
    section.add_region("lower", {{{0, 0}, "base"}, {{1, 0}, ""}, {{1, 1}, ""}, {{0, 1}, ""}});
    section.add_region("upper", {{{0, 1}, ""}, {{1, 1}, ""}, {{1, 2}, "top"}, {{0, 2}, ""}});
    const std::string text = section.text();
    EXPECT_NE(text.find("Curve Loop(1) = {1, 2, 3, 4};"), std::string::npos) << text;
    EXPECT_NE(text.find("Curve Loop(2) = {-3, 5, 6, 7};"), std::string::npos) << text;
    EXPECT_NE(text.find("Point(6) = {0, 2, 0};"), std::string::npos) << text;
    EXPECT_EQ(text.find("Point(7)"), std::string::npos) << text;
    EXPECT_NE(text.find("Physical Curve(\"top\") = {6};"), std::string::npos) << text;
}

TEST(DesignedSet, EveryRowHasAFolderOfItsOwnAndASceneThatCanBeRead)
{
    const fixtures::TemporaryFolder folder;
    std::set<std::string> names;
    for (const StressRow& row : designed_rows(true)) {
        EXPECT_TRUE(names.insert(row.id()).second) << row.id();
        const RowFiles files = files_of(folder.path(), row);
        write_row(row, files);
        EXPECT_NO_THROW(read_scene_file(files.scene(), {})) << row.id();
    }
}

TEST(DesignedSet, GroupsAreToldOnceEach)
{
    const std::vector<std::string> groups = stress_groups();
    EXPECT_EQ(std::set<std::string>(groups.begin(), groups.end()).size(), groups.size());
    EXPECT_EQ(groups.front(), "steps");
    EXPECT_EQ(groups.back(), "random");
}

} // namespace
} // namespace quicksand
