#include "io/files/file_error.hpp"
#include "io/pictures/line_plot.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

/// PATH as it was at the end of the test.
class OtherPath {
public:
    explicit OtherPath(const std::filesystem::path& path) : former_(getenv("PATH"))
    {
        setenv("PATH", path.c_str(), 1);
    }
    ~OtherPath() { setenv("PATH", former_.c_str(), 1); }
    OtherPath(const OtherPath&) = delete;
    OtherPath& operator=(const OtherPath&) = delete;

private:
    std::string former_;
};

Drawing line_to(const std::filesystem::path& png)
{
    const PlotPanel panel{"Time [s]", "u [m]", {{"crest", {}, {0.0, 1.0, 2.0}, {0.0, 3.0, 1.0}}}};
    return plot_drawing({"A line", "", {panel}}, png);
}

std::string complaint(const std::vector<Drawing>& drawings)
{
    try {
        draw_pictures(drawings);
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

/// A program of that name in the folder.
void write_program(const std::filesystem::path& file, const std::string& commands)
{
    std::ofstream(file) << "#!/bin/sh\n" << commands;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

constexpr const char* still_good = "; the results themselves are untouched";

} // namespace

TEST(Gnuplot, DrawsCoursesThatRoundingAloneMoves)
{
    const TemporaryFolder folder;
    for (const double size : {1e-12, 1e2})
        for (const double change : {0.0, 1e-14, 1e-12, 1e-9})
            for (const KeyPlace key : {KeyPlace::above, KeyPlace::upper_left}) {
                PlotPanel panel{
                    "Time [s]", "u [m]", {{"u", {}, {0.0, 1.0, 2.0}, {size, size + change, size}}}};
                panel.key = key;
                const std::vector<Drawing> drawings{plot_drawing({"A line", "", {panel}}, folder / "a.png")};
                EXPECT_EQ(complaint(drawings), "") << size << ' ' << change;
            }
}

TEST(Gnuplot, DrawsSeveralPicturesTheSameEveryTime)
{
    const TemporaryFolder folder;
    const auto files = draw_pictures({line_to(folder / "it's.png"), line_to(folder / "b.png")});
    EXPECT_EQ(files, (std::vector{folder / "it's.png", folder / "b.png"}));
    EXPECT_GT(std::filesystem::file_size(folder / "b.png"), 10'000u);
    EXPECT_LT(std::filesystem::file_size(folder / "b.png"), 1'000'000u);
    EXPECT_EQ(fixtures::text_of(folder / "it's.png"), fixtures::text_of(folder / "b.png"));
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(Gnuplot, MissingSaysWhatToInstall)
{
    const TemporaryFolder folder;
    const OtherPath path("/nonexistent");
    EXPECT_EQ(complaint({line_to(folder / "a.png")}),
              (folder / "a.png").string() +
                  ": cannot draw: the program gnuplot is not installed (Debian: gnuplot-nox)" + still_good);
}

TEST(Gnuplot, PassesItsComplaintOnAndKeepsWhatItDrewBefore)
{
    const TemporaryFolder folder;
    const std::string said =
        complaint({line_to(folder / "a.png"), line_to(folder / "missing/b.png"), line_to(folder / "c.png")});
    EXPECT_TRUE(said.starts_with((folder / "missing/b.png").string() + ": cannot draw: gnuplot failed: "))
        << said;
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "c.png"));
}

TEST(Gnuplot, OnAFullDiskLeavesTheFormerPicture)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "a.png") << "former";
    {
        const fixtures::FullDisk disk(8000);
        EXPECT_EQ(complaint({line_to(folder / "a.png")}),
                  (folder / "a.png").string() +
                      ": cannot draw: gnuplot wrote only a part of the picture; is the disk full?" +
                      still_good);
    }
    EXPECT_EQ(fixtures::text_of(folder / "a.png"), "former");
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(Gnuplot, KilledWhileItWritesLeavesTheFormerPicture)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "a.png") << "former";
    write_program(folder / "gnuplot",
                  "printf 'half' >'" + (folder / "a.png.tmp").string() + "'\nkill -9 $$\n");
    const OtherPath path(folder.path());
    EXPECT_EQ(complaint({line_to(folder / "a.png")}),
              (folder / "a.png").string() + ": cannot draw: gnuplot failed" + still_good);
    EXPECT_EQ(fixtures::text_of(folder / "a.png"), "former");
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

} // namespace quicksand
