// Files that are not there or hold no text, long batches, and values of the command line.
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::replaced;
using fixtures::SceneFolder;

std::string refusal_of(const std::filesystem::path& file)
{
    try {
        read_scene_file(file, {});
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SceneFile, MissingIsNamed)
{
    EXPECT_EQ(refusal_of("no/such/scene.toml"), "no/such/scene.toml: error[file]: does not exist");
}

TEST(SceneFile, FolderIsNoScene)
{
    EXPECT_EQ(refusal_of("/usr"), "/usr: error[file]: is a folder, not a file\nhint: name a file in it");
}

TEST(SceneFile, DeviceIsNoScene)
{
    EXPECT_EQ(refusal_of("/dev/zero"), "/dev/zero: error[file]: is not a regular file");
}

TEST(SceneFile, OneBeyondAllScenesIsNotRead)
{
    const fixtures::TemporaryFolder folder;
    const std::filesystem::path file = folder / "scene.toml";
    std::ofstream(file) << column_scene;
    std::filesystem::resize_file(file, (std::uintmax_t(64) << 20) + 1);
    EXPECT_EQ(refusal_of(file),
              file.string() + ": error[file]: is larger than 64 MiB\nhint: is it the right file?");
}

TEST(SceneFile, BinaryIsNoScene)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message(std::string("PK\x03\x04\0\0", 6)),
              "scene.toml: error[file]: is not a text file\nhint: is it the right file?\n");
}

TEST(SceneFile, Utf16IsNamed)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message("\xFF\xFEs\0"),
              "scene.toml: error[file]: is UTF-16 text\nhint: save it as UTF-8\n");
}

TEST(SceneFile, Latin1IsNamedWithItsPlace)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message("scene_version = 1\ntitle = \"D\xE4mme\"\n"),
              R"(scene.toml:2:11: error[encoding]: this is not UTF-8 text
    2 | title = "D?mme"
      |           ^
hint: save the file as UTF-8
)");
}

TEST(SceneFile, EmptyOneNamesAllThatIsMissing)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message(""), R"(scene.toml: error[missing-key]: the scene has no scene_version
expected: scene_version: Version of the scene format: 1.
hint: begin the scene with the line scene_version = 1
scene.toml: error[missing-table]: there is no table [geometry]
expected: a table [geometry] with file: The drawn cross-section.
scene.toml: error[missing-table]: there is no table [materials.NAME]
expected: a table [materials.NAME]: The soils.
scene.toml: error[missing-table]: there is no table [regions.NAME]
expected: a table [regions.NAME]: The materials of the physical surfaces.
scene.toml: error[missing-table]: there is no table [run]
expected: a table [run] with end_time: The run.
)");
}

TEST(SceneFile, MoreThanTwentyErrorsAreCounted)
{
    const SceneFolder folder;
    std::string text = column_scene;
    for (int k = 0; k < 27; ++k) text += std::string("key") + std::to_string(k) + " = 1\n";
    const std::string message = folder.message(text);
    EXPECT_NE(message.find("unknown key 'key19'"), std::string::npos);
    EXPECT_EQ(message.find("unknown key 'key20'"), std::string::npos);
    EXPECT_TRUE(message.ends_with("... and 7 more errors\n")) << message;
}

TEST(SceneFile, MoreThanFiveWarningsOfAKindAreCounted)
{
    const SceneFolder folder;
    std::string text = column_scene;
    for (int k = 0; k < 8; ++k) {
        text += std::string("[materials.m") + std::to_string(k) +
                "]\nmodel = \"linear_elastic\"\nshear_modulus = 1e6\n" +
                "poisson_ratio = 0.3\nporosity = 0.4\nhydraulic_conductivity = 1e-5\n";
    }
    EXPECT_TRUE(folder.message(text).ends_with("... and 3 more warnings of kind [unused]\n"));
}

TEST(SceneFile, ErrorsStandInTheOrderOfTheFile)
{
    const SceneFolder folder;
    std::string text = replaced(column_scene, "end_time = 0.2", "end_time = -1");
    text = replaced(text, "title", "titel");
    const std::string message = folder.message(text);
    EXPECT_LT(message.find("scene.toml:2:1: error"), message.find("scene.toml:50:12: error"));
}

TEST(SceneFile, CaretStandsBelowTheMarkAfterUmlautsAndInLongLines)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message(replaced(column_scene, "title = \"column\"", "probes.\"öä\" = 1")),
              R"(scene.toml:2:15: error[type]: probes."öä" is a number
    2 | probes."öä" = 1
      |               ^
expected: a table, that is a line [probes."öä"] and its keys below it
)");
    const std::string names(300, 'x');
    const std::string message =
        folder.message(replaced(column_scene, "title", std::string("\"") + names + "\" = 1 # "));
    EXPECT_NE(message.find("...\n      | ^~~~"), std::string::npos) << message;
}

TEST(SceneOverride, IsNamedInErrors)
{
    const SceneFolder folder;
    EXPECT_EQ(
        folder.message(column_scene, {"materials.sand.porosity=40"}),
        R"(--set 'materials.sand.porosity=40': error[range]: materials.sand.porosity = 40 is out of range
expected: more than 0 and less than 1
hint: did you mean 0.4 (40 %)?
)");
}

TEST(SceneOverride, OfAnUnknownKeyIsRefused)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message(column_scene, {"run.end_tme=1"}),
              R"(--set 'run.end_tme=1': error[unknown-key]: unknown key 'end_tme' in [run]
expected: end_time
hint: did you mean end_time?
)");
}

TEST(SceneOverride, OfTwoLinesIsRefused)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message(column_scene, {"title=\"a\nb\""}),
              "--set 'title=\"a\nb\"': error[set]: it is not a single line of text\n"
              "expected: path=value, as materials.sand.porosity=0.4\n");
}

TEST(SceneOverride, WithoutPathOrValueIsRefused)
{
    const SceneFolder folder;
    EXPECT_EQ(folder.message(column_scene, {"run.end_time", "run.end_time="}),
              R"(--set 'run.end_time': error[set]: there is no path before an equals sign
expected: path=value, as materials.sand.porosity=0.4
--set 'run.end_time=': error[set]: there is no value
expected: path=value, as materials.sand.porosity=0.4
)");
}

} // namespace
} // namespace quicksand
