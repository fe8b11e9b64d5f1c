#include "io/keys/scene_schema.hpp"

#include <gtest/gtest.h>

#include <set>

namespace quicksand {
namespace {

TEST(SceneSchema, NamesEveryKeyOnceBelowATable)
{
    std::set<std::string_view> seen;
    for (const SceneKey& key : scene_key_table().keys) {
        EXPECT_TRUE(seen.insert(key.pattern).second) << key.pattern;
        const std::string_view table = table_part(key.pattern);
        EXPECT_TRUE(table.empty() || seen.contains(table)) << key.pattern;
        EXPECT_FALSE(key.doc.empty()) << key.pattern;
        EXPECT_TRUE(key.doc.ends_with('.')) << key.pattern;
    }
}

TEST(SceneSchema, HasDefaultsWithinTheirOwnBands)
{
    for (const SceneKey& key : scene_key_table().keys) {
        if (!key.default_value || !std::holds_alternative<double>(*key.default_value)) continue;
        const double value = std::get<double>(*key.default_value);
        EXPECT_TRUE(key.allowed.contains(value)) << key.pattern;
        EXPECT_TRUE(key.plausible.contains(value)) << key.pattern;
    }
}

TEST(SceneSchema, RefersToSiblingsThatStandAbove)
{
    std::set<std::string> above;
    for (const SceneKey& key : scene_key_table().keys) {
        const std::string table(table_part(key.pattern));
        for (const std::string_view sibling : {key.when.sibling, key.derived.sibling}) {
            if (!sibling.empty()) {
                EXPECT_TRUE(above.contains(table + "." + std::string(sibling))) << key.pattern;
            }
        }
        if (!key.derived.key.empty()) {
            EXPECT_TRUE(above.contains(std::string(key.derived.key))) << key.pattern;
        }
        above.emplace(key.pattern);
    }
}

TEST(SceneSchema, FindsKeysByThePathOfAnyName)
{
    EXPECT_EQ(find_key(scene_key_table(), {"materials", "a.b \"c\"", "porosity"})->pattern,
              "materials.*.porosity");
    EXPECT_EQ(find_key(scene_key_table(), {"grid"})->pattern, "grid");
    EXPECT_EQ(find_key(scene_key_table(), {"materials", "sand", "porosity", "x"}), nullptr);
    EXPECT_EQ(join_path({"materials", "fine sand", "porosity"}), "materials.\"fine sand\".porosity");
    EXPECT_EQ(join_path({"materials", "a \"b\" \\ c"}), "materials.\"a \\\"b\\\" \\\\ c\"");
}

TEST(SceneSchema, DescribesAKey)
{
    EXPECT_EQ(describe_keys(scene_key_table(), "conductivity_gravity"), R"(materials.NAME.conductivity_gravity
    Gravity at which the conductivity was measured; at 120 g a wrong value changes k by a factor of 120.
    is       number in m/s2
    default  9.81
    used     with water = "pores", with water.flow = "coupled" or water.initial_flow = "seepage"
    range    more than 0 m/s2
    usual    1 to 2000 m/s2
)");
    EXPECT_EQ(describe_keys(scene_key_table(), "no such key"), "");
}

TEST(SceneSchema, WritesEveryKeyIntoTheReference)
{
    const std::string all = describe_keys(scene_key_table(), ""), tables = keys_markdown(scene_key_table());
    for (const SceneKey& key : scene_key_table().keys) {
        const std::string name(last_part(key.pattern));
        if (name == "*") continue;
        EXPECT_NE(all.find(name), std::string::npos) << key.pattern;
        EXPECT_NE(tables.find(name), std::string::npos) << key.pattern;
    }
}

} // namespace
} // namespace quicksand
