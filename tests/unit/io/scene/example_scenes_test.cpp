// Every scene that comes with the program is read without an error or a warning.
#include "io/scene/scene_file.hpp"
#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace quicksand {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes()
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(in_checkout("examples"))) {
        const std::string folder = entry.path().parent_path().filename().string();
        const bool other = folder.starts_with("element") || folder == "sweep"; // files of another kind
        if (entry.path().extension() == ".toml" && !other) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(ExampleScenes, AreReadWithoutAWarning)
{
    ASSERT_GT(scenes().size(), 20U);
    for (const fs::path& file : scenes()) {
        SCOPED_TRACE(file.string());
        SceneReading reading;
        ASSERT_NO_THROW(reading = read_scene_file(file, {}));
        EXPECT_EQ(reading.warnings.render(reading.scene.text), "");
    }
}

} // namespace
} // namespace quicksand
