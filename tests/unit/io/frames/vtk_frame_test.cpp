#include "io/files/file_error.hpp"
#include "io/frames/vtk_frame.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

Frame two_quads()
{
    Frame frame;
    frame.time = 1.0 / 3.0;
    frame.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {2.0, 0.0}, {2.0, 1.0 / 3.0}};
    frame.cells = {{0, 1, 2, 3, 1, 4, 5, 2}, {0, 4, 8}};
    frame.point_data = {{"pore_pressure", "Pa", {}, std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 1.0 / 3.0}}};
    frame.cell_data = {{"stress", "Pa", {"XX", "YY", "ZZ", "XY"}, std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8}},
                       {"material", "-", {}, std::vector<std::int32_t>{7, 9}}};
    frame.texts = {{"material_names", {"sand", "clay"}}};
    return frame;
}

} // namespace

TEST(VtkFrame, ReadsBackWhatWasWritten)
{
    const TemporaryFolder folder;
    const Frame written = two_quads();
    write_frame(folder / "a.vtu", written);
    const Frame read = read_frame(folder / "a.vtu");
    EXPECT_EQ(read.time, written.time);
    EXPECT_EQ(read.points, written.points);
    EXPECT_EQ(read.cells, written.cells);
    ASSERT_EQ(read.point_data.size(), 1u);
    EXPECT_EQ(read.point_data[0].values, written.point_data[0].values);
    ASSERT_EQ(read.cell_data.size(), 2u);
    EXPECT_EQ(read.cell_data[0].components, written.cell_data[0].components);
    EXPECT_EQ(read.cell_data[0].values, written.cell_data[0].values);
    EXPECT_EQ(read.cell_data[0].unit, "Pa");
    EXPECT_EQ(read.cell_data[1].values, written.cell_data[1].values);
    ASSERT_EQ(read.texts.size(), 1u);
    EXPECT_EQ(read.texts[0].lines, written.texts[0].lines);
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(VtkFrame, IsXmlThroughout)
{
    const TemporaryFolder folder;
    write_frame(folder / "a.vtu", two_quads());
    const std::string text = fixtures::text_of(folder / "a.vtu");
    EXPECT_EQ(text.find("AppendedData"), std::string::npos);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(),
                            [](char letter) { return letter == '\n' || (letter >= ' ' && letter <= '~'); }));
}

TEST(VtkFrame, AFullDiskLeavesNothingBehind)
{
    const TemporaryFolder folder;
    {
        const fixtures::FullDisk full(256);
        EXPECT_THROW(write_frame(folder / "a.vtu", two_quads()), FileError);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(VtkFrame, AMissingFolderIsAFileErrorThatNamesTheFile)
{
    try {
        write_frame("/nowhere/a.vtu", two_quads());
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(error.path, "/nowhere/a.vtu");
    }
}

TEST(VtkFrame, ADamagedFileIsAFileError)
{
    const TemporaryFolder folder;
    write_frame(folder / "a.vtu", two_quads());
    const std::string text = fixtures::text_of(folder / "a.vtu");
    std::ofstream(folder / "a.vtu", std::ios::binary) << text.substr(0, text.size() / 3);
    const auto failure_of = [](const std::filesystem::path& path) {
        try {
            read_frame(path);
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(failure_of(folder / "a.vtu"),
              (folder / "a.vtu").string() +
                  ": cannot read the frame: it is damaged or not written by Quicksand");
    EXPECT_EQ(failure_of(folder / "missing.vtu"),
              (folder / "missing.vtu").string() + ": cannot read the frame: no such file");
}

TEST(VtkFrame, PolygonsReadBackBesideQuadrilaterals)
{
    const TemporaryFolder folder;
    Frame written = two_quads();
    written.cells = {{0, 1, 3, 1, 4, 5, 2, 0, 1, 4, 5, 3}, {0, 3, 7, 12}};
    written.cell_data = {{"material", "-", {}, std::vector<std::int32_t>{7, 9, 8}}};
    write_frame(folder / "a.vtu", written);
    const Frame read = read_frame(folder / "a.vtu");
    EXPECT_EQ(read.cells, written.cells);
    EXPECT_EQ(read.cells[2].size(), 5u);
    EXPECT_EQ(read.cells[2][3], 5);
    EXPECT_EQ(read.cell_data[0].values, written.cell_data[0].values);
}

TEST(VtkFrame, AnEmptyFrameReadsBack)
{
    const TemporaryFolder folder;
    write_frame(folder / "a.vtu", Frame{});
    EXPECT_EQ(read_frame(folder / "a.vtu").cells.size(), 0u);
}

} // namespace quicksand
