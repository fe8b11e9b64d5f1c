#include "io/files/file_error.hpp"
#include "io/frames/vtk_series.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

Frame quad_at(double time)
{
    Frame frame;
    frame.time = time;
    frame.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    frame.cells = {{0, 1, 2, 3}, {0, 4}};
    return frame;
}

std::vector<double> times_in(const std::filesystem::path& index)
{
    std::vector<double> times;
    for (const FrameEntry& entry : read_series_index(index)) {
        EXPECT_EQ(read_frame(index.parent_path() / entry.file).time, entry.time);
        times.push_back(entry.time);
    }
    return times;
}

/// What is said of an index that cannot be read, without its path.
template <class Failure>
std::string failure_of(const std::filesystem::path& index)
{
    try {
        read_series_index(index);
    } catch (const Failure& failure) {
        return std::string(failure.what()).substr(index.string().size() + 2);
    }
    return "";
}

} // namespace

TEST(VtkSeries, IsReadableAndCleanAfterEveryFrame)
{
    const TemporaryFolder folder;
    VtkSeries series(folder / "fields.pvd");
    EXPECT_TRUE(times_in(folder / "fields.pvd").empty());
    std::vector<double> expected;
    for (int k = 0; k < 4; ++k) {
        expected.push_back(k / 3.0);
        series.append(quad_at(expected.back()));
        EXPECT_EQ(times_in(folder / "fields.pvd"), expected);
        EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
    }
}

TEST(VtkSeries, IndexTextIsAsParaViewWantsIt)
{
    const TemporaryFolder folder;
    VtkSeries series(folder / "fields.pvd");
    series.append(quad_at(0.1));
    EXPECT_EQ(fixtures::text_of(folder / "fields.pvd"),
              "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
              "  <Collection>\n"
              "    <DataSet timestep=\"0.10000000000000001\" part=\"0\" file=\"fields/frame_000000.vtu\"/>\n"
              "  </Collection>\n"
              "</VTKFile>\n");
}

TEST(VtkSeries, ResumeDropsLaterFramesAndGoesOn)
{
    const TemporaryFolder folder;
    {
        VtkSeries series(folder / "grid.pvd");
        for (const double time : {0.0, 0.1, 0.2, 0.3}) series.append(quad_at(time));
    }
    std::ofstream(folder / "grid/frame_000004.vtu.tmp") << "half";
    VtkSeries series = VtkSeries::resume(folder / "grid.pvd", 0.1);
    EXPECT_FALSE(std::filesystem::exists(folder / "grid/frame_000002.vtu"));
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
    series.append(quad_at(0.2));
    EXPECT_EQ(times_in(folder / "grid.pvd"), (std::vector<double>{0.0, 0.1, 0.2}));
    EXPECT_EQ(series.entries().back().file, "grid/frame_000002.vtu");
}

TEST(VtkSeries, AFullDiskKeepsTheFramesBefore)
{
    const TemporaryFolder folder;
    VtkSeries series(folder / "fields.pvd");
    series.append(quad_at(0.0));
    {
        const fixtures::FullDisk full(512);
        EXPECT_THROW(series.append(quad_at(0.1)), FileError);
    }
    EXPECT_EQ(times_in(folder / "fields.pvd"), std::vector<double>{0.0});
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(VtkSeries, AMissingIndexIsTheUsersAndADamagedOneTheDisks)
{
    const TemporaryFolder folder;
    EXPECT_EQ(failure_of<InputError>(folder / "fields.pvd"),
              "there is no such series. Is this the results folder of a run?");
    std::ofstream(folder / "cut.pvd") << "<VTKFile><Collection><DataSet timestep=\"0\" file=\"a";
    EXPECT_EQ(failure_of<FileError>(folder / "cut.pvd"),
              "cannot read the index: it is cut off or not a .pvd file");
    std::ofstream(folder / "odd.pvd") << "<VTKFile><DataSet timestep=\"zero\" file=\"a\"/></VTKFile>";
    EXPECT_EQ(failure_of<FileError>(folder / "odd.pvd"),
              "cannot read the index: damaged entry: <DataSet timestep=\"zero\" file=\"a\"/");
}

} // namespace quicksand
