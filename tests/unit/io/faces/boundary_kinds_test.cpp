#include "io/faces/boundary_keys.hpp"
#include "io/faces/boundary_kinds.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace quicksand {
namespace {

TEST(BoundaryKinds, HaveWordsOfTheirOwn)
{
    std::set<std::string_view> words;
    for (const SceneSoilKind& kind : soil_kinds()) EXPECT_TRUE(words.insert(kind.word).second) << kind.word;
    EXPECT_EQ(words.size(), std::variant_size_v<SoilCondition>);
    for (const SceneWaterKind& kind : water_kinds()) EXPECT_TRUE(words.insert(kind.word).second) << kind.word;
}

TEST(BoundaryKinds, AreReadByTheirWords)
{
    const std::map<std::string_view, std::string> needs = {{"moving", "velocity = [0, 0]"}};
    for (const SceneSoilKind& kind : soil_kinds()) {
        if (kind.word == "tied") continue; // two together, as the sides of the example
        std::string table = "soil = \"" + std::string(kind.word) + "\"";
        if (needs.contains(kind.word)) table += "\n" + needs.at(kind.word);
        const std::string text = fixtures::replaced(fixtures::column_scene, "soil = \"fixed\"", table);
        const Scene scene = fixtures::SceneFolder().read(text).scene;
        EXPECT_EQ(&kind_of(scene.boundaries.at(0).boundary.soil), &kind) << kind.word;
        EXPECT_EQ(kind_of(scene.boundaries.at(1).boundary.soil).word, "tied");
        const bool drained = std::holds_alternative<Drained>(scene.boundaries.at(0).boundary.water);
        EXPECT_EQ(drained ? "drained" : "impervious", kind.water) << kind.word;
    }
}

TEST(BoundaryKinds, HaveTheirKeysForThemselves)
{
    const std::vector<SceneKey> keys = boundary_keys();
    for (const SceneSoilKind& kind : soil_kinds()) {
        for (const SceneKey& own : kind.keys) {
            const auto row = std::find_if(keys.begin(), keys.end(),
                                          [&](const SceneKey& key) { return key.pattern == own.pattern; });
            ASSERT_NE(row, keys.end()) << own.pattern;
            EXPECT_EQ(row->when.sibling, "soil");
            EXPECT_EQ(row->when.words, std::vector<std::string_view>{kind.word});
        }
        for (const std::string_view varying : kind.varying) {
            EXPECT_TRUE(std::any_of(kind.keys.begin(), kind.keys.end(), [&](const SceneKey& key) {
                return last_part(key.pattern) == varying;
            })) << varying;
        }
    }
}

} // namespace
} // namespace quicksand
