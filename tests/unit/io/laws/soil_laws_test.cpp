#include "io/keys/scene_schema.hpp"
#include "io/laws/soil_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

const SceneKey& key_named(const std::vector<SceneKey>& keys, std::string_view name)
{
    return *std::find_if(keys.begin(), keys.end(),
                         [&](const SceneKey& key) { return last_part(key.pattern) == name; });
}

TEST(SoilLaws, GiveEveryKeyTheModelsThatHaveIt)
{
    const std::vector<SceneKey> keys = soil_law_keys();
    using Words = std::vector<std::string_view>;
    EXPECT_EQ(key_named(keys, "shear_modulus").when.words,
              (Words{"linear_elastic", "mohr_coulomb", "neo_hookean"}));
    EXPECT_EQ(key_named(keys, "cohesion").when.words, (Words{"mohr_coulomb", "ubcsand"}));
    EXPECT_EQ(key_named(keys, "n1_60").when.words, (Words{"ubcsand", "pm4sand"}));
    for (const SceneKey& key : keys) {
        EXPECT_EQ(key.when.sibling, "model") << key.pattern;
        EXPECT_EQ(std::count_if(keys.begin(), keys.end(),
                                [&](const SceneKey& other) { return other.pattern == key.pattern; }),
                  1)
            << key.pattern;
    }
}

TEST(SoilLaws, AreFoundByWordAndByForm)
{
    for (const SoilLaw& law : soil_laws()) {
        EXPECT_EQ(&soil_law(law.word), &law);
        EXPECT_EQ(&soil_law(law.form), &law);
    }
    EXPECT_EQ(soil_law("linear_elastick").word, "linear_elastic");
}

} // namespace
} // namespace quicksand
