// Damaged scenes: whatever the bytes, a scene is read or refused.
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <random>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::SceneFolder;

std::size_t below(std::mt19937& random, std::size_t limit)
{
    return static_cast<std::size_t>(random()) % limit;
}

/// One small damage: a character lost, changed or put in, a piece doubled or moved, a value exchanged.
void damage(std::mt19937& random, std::string& text)
{
    static const std::vector<std::string> pieces = {
        "[",  "]",    "\n",     "\"",       "=",   "inf",        "-1",    "1e400",
        "{}", "'''",  "\"\"\"", "\\",       "#",   "\0\0",       "\xC3",  "\xE2\x80\x9C",
        ".",  "true", "[[a]]",  "[grid]\n", "nan", "1979-05-27", "\\u12", "99999999999999999999"};
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = below(random, 12);
    switch (below(random, 5)) {
    case 0:
        text.erase(at, length);
        break;
    case 1:
        text.insert(at, pieces[below(random, pieces.size())]);
        break;
    case 2:
        text.insert(at, text.substr(below(random, text.size() + 1), length * 4));
        break;
    case 3:
        if (at < text.size()) text[at] = static_cast<char>(below(random, 256));
        break;
    default:
        text.replace(at, length, pieces[below(random, pieces.size())]);
        break;
    }
}

TEST(DamagedScene, IsReadOrRefused)
{
    std::mt19937 random(20240229);
    const SceneFolder folder;
    int read = 0, refused = 0;
    for (int k = 0; k < 2000; ++k) {
        std::string text = column_scene;
        for (std::size_t damages = 1 + below(random, 4); damages > 0; --damages) damage(random, text);
        try {
            folder.read(text);
            ++read;
        } catch (const InputError& error) {
            ++refused;
            ASSERT_NE(std::string(error.what()), "");
        }
    }
    EXPECT_GT(read, 20);
    EXPECT_GT(refused, 1000);
}

TEST(DamagedOverride, IsReadOrRefused)
{
    std::mt19937 random(20240301);
    const SceneFolder folder;
    for (int k = 0; k < 1000; ++k) {
        std::string override = "materials.sand.porosity=0.4";
        for (int damages = 0; damages < 3; ++damages) damage(random, override);
        try {
            folder.read(column_scene, {override});
        } catch (const InputError& error) {
            ASSERT_NE(std::string(error.what()), "");
        }
    }
}

} // namespace
} // namespace quicksand
