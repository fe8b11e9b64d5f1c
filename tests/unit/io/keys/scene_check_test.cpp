#include "io/keys/scene_check.hpp"
#include "io/keys/scene_words.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

SceneValues with_grid()
{
    SceneValues values;
    values.table = &scene_key_table();
    values.by_path["grid.cell_size"] = {0.5, true, {}};
    return values;
}

TEST(SceneValues, AnswerForTheKeysOfTheirTable)
{
    const SceneValues values = with_grid();
    EXPECT_EQ(values.number("grid.cell_size"), 0.5);
    EXPECT_EQ(values.number("materials.any name.porosity"), 0.0); // missing where the file has an error
}

TEST(SceneValues, AKeyThatNoTableHasIsOurBug)
{
    const SceneValues values = with_grid();
    EXPECT_THROW(values.number("grid.cell_sise"), InternalError);
    EXPECT_THROW(values.text("materials.sand.modell"), InternalError);
    EXPECT_THROW(values.given("typo"), InternalError);
}

TEST(SceneValues, AnotherTypeThanTheRowSaysIsOurBug)
{
    EXPECT_THROW(with_grid().text("grid.cell_size"), InternalError);
}

TEST(SceneWords, AWordThatStandsForNothingIsOurBug)
{
    constexpr WordList<int, 2> words = {{{"one", 1}, {"two", 2}}};
    EXPECT_EQ(word_of(words, "two"), 2);
    EXPECT_EQ(word_of(words, ""), 1);
    EXPECT_THROW(word_of(words, "three"), InternalError);
}

} // namespace
} // namespace quicksand
