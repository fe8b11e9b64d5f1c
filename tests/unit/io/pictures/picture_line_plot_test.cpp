#include "io/files/file_error.hpp"
#include "io/pictures/line_plot.hpp"
#include "io/pictures/picture_isochrones.hpp"
#include "io/pictures/picture_probes.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <string>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

PictureTable probe_table()
{
    PictureTable table;
    table.comments = {
        "probe: P_1, material: rides with particle 7, nearest to (0.1, 0.2) m when shaking began"};
    table.columns = {"time_s", "ux_m", "uy_m", "vx_m_s", "ax_m_s2", "excess_pore_pressure_Pa", "ru"};
    table.values = {{0.0, 0.1, 0.2},   {0.0, 0.001, 0.002},       {0.0, -0.001, -0.004},
                    {0.0, 0.02, 0.01}, {std::nan(""), 0.2, -0.1}, {0.0, 4000.0, 9000.0},
                    {0.0, 0.4, 0.9}};
    return table;
}

/// Three times four points of a vertical line.
PictureTable profile_table()
{
    PictureTable table;
    table.columns = {"time_s", "distance_m", "x_m", "y_m", "excess_pore_pressure_Pa"};
    table.values.resize(5);
    for (int frame = 0; frame < 3; ++frame)
        for (int point = 0; point < 4; ++point) {
            table.values[0].push_back(0.5 * frame);
            table.values[1].push_back(point);
            table.values[2].push_back(1.0);
            table.values[3].push_back(point);
            table.values[4].push_back(1000.0 * frame * point);
        }
    return table;
}

/// PATH as it was at the end of the test.
class EmptyPath {
public:
    EmptyPath() : former_(getenv("PATH")) { setenv("PATH", "/nonexistent", 1); }
    ~EmptyPath() { setenv("PATH", former_.c_str(), 1); }

private:
    std::string former_;
};

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST(ProbePlot, LabelsCarryUnitsWithPrefix)
{
    const auto plot = probe_plot(probe_table(), "P_1");
    ASSERT_TRUE(plot);
    const std::string script = plot_script(*plot, "out.png");
    EXPECT_TRUE(contains(script, "'Excess pore pressure [kPa]'"));
    EXPECT_TRUE(contains(script, "'Displacement [mm]'"));
    EXPECT_TRUE(contains(script, "'Velocity [mm/s]'"));
    EXPECT_TRUE(contains(script, "'Acceleration [mm/s²]'"));
    EXPECT_TRUE(contains(script, "'Time [s]'"));
    EXPECT_TRUE(contains(script, "'Probe P_1'"));
    EXPECT_TRUE(contains(script, "pngcairo noenhanced"));
    EXPECT_TRUE(contains(script, "\n0.1 4\n0.2 9\n"));
    EXPECT_TRUE(contains(script, "\n0 NaN\n"));
}

TEST(ProbePlot, QuotesInNamesAreDoubled)
{
    const std::string script = plot_script(*probe_plot(probe_table(), "toe's"), "a'b.png");
    EXPECT_TRUE(contains(script, "'Probe toe''s'"));
    EXPECT_TRUE(contains(script, "set output 'a''b.png'"));
}

TEST(ProbePlot, OfAProfileIsIsochrones)
{
    const auto plot = probe_plot(profile_table(), "axis");
    ASSERT_TRUE(plot);
    ASSERT_EQ(plot->panels.size(), 1u);
    EXPECT_EQ(plot->panels[0].x_label, "Excess pore pressure [kPa]");
    EXPECT_EQ(plot->panels[0].y_label, "y [m]");
    ASSERT_EQ(plot->panels[0].curves.size(), 3u);
    EXPECT_EQ(plot->panels[0].curves[2].name, "t = 1 s");
    EXPECT_EQ(plot->panels[0].curves[2].x, (std::vector<double>{0.0, 2.0, 4.0, 6.0}));
}

TEST(ProbePlot, ATableWithoutValuesHasNone)
{
    PictureTable table = probe_table();
    for (std::size_t c = 1; c < table.values.size(); ++c) table.values[c].assign(3, std::nan(""));
    EXPECT_FALSE(probe_plot(table, "P_1"));
    EXPECT_FALSE(comparison_plot({{"P_1", probe_table()}}));
}

TEST(ChooseProfiles, TakesEvenTimesWithBothEnds)
{
    std::vector<double> times;
    for (int k = 0; k <= 100; ++k) times.insert(times.end(), 3, 0.1 * k);
    const auto chosen = choose_profiles(times, 8);
    ASSERT_EQ(chosen.size(), 8u);
    EXPECT_EQ(chosen.front().time, 0.0);
    EXPECT_EQ(chosen.back().end, times.size());
    for (const ProfileRows& rows : chosen) EXPECT_EQ(rows.end - rows.begin, 3u);
}

TEST(LinePlot, IsDrawnByGnuplot)
{
    const TemporaryFolder folder;
    draw_line_plot(*probe_plot(probe_table(), "P_1"), folder / "it's.png");
    EXPECT_GT(std::filesystem::file_size(folder / "it's.png"), 10'000u);
    EXPECT_LT(std::filesystem::file_size(folder / "it's.png"), 1'000'000u);
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(LinePlot, WithoutGnuplotSaysWhatToInstall)
{
    const TemporaryFolder folder;
    const EmptyPath path;
    try {
        draw_line_plot(*probe_plot(probe_table(), "P_1"), folder / "a.png");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_TRUE(contains(error.what(), "gnuplot is not installed (Debian: gnuplot-nox)")) << error.what();
    }
}

TEST(LinePlot, PassesGnuplotsComplaintOn)
{
    const TemporaryFolder folder;
    try {
        draw_line_plot(*probe_plot(probe_table(), "P_1"), folder / "missing/a.png");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_TRUE(contains(error.what(), "gnuplot failed: ")) << error.what();
    }
}

} // namespace quicksand
