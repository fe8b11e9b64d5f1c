#include "io/pictures/line_plot.hpp"
#include "io/pictures/picture_isochrones.hpp"
#include "io/pictures/picture_probes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quicksand {

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

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST(ProbePlot, LabelsCarryUnitsWithPrefix)
{
    const auto plot = probe_plot(probe_table(), "P_1");
    ASSERT_TRUE(plot);
    const std::string script = plot_drawing(*plot, "out.png").commands;
    EXPECT_TRUE(contains(script, "'Excess pore pressure [kPa]'"));
    EXPECT_TRUE(contains(script, "'Displacement [mm]'"));
    EXPECT_TRUE(contains(script, "'Velocity of the grains [mm/s]'"));
    EXPECT_TRUE(contains(script, "'Acceleration [mm/s²]'"));
    EXPECT_TRUE(contains(script, "'Time [s]'"));
    EXPECT_TRUE(contains(script, "'Probe P_1'"));
    EXPECT_TRUE(contains(script, "\n0.1 4\n0.2 9\n"));
    EXPECT_TRUE(contains(script, "\n0 NaN\n"));
}

TEST(ProbePlot, QuotesInNamesAreDoubled)
{
    const std::string script = plot_drawing(*probe_plot(probe_table(), "toe's"), "a.png").commands;
    EXPECT_TRUE(contains(script, "'Probe toe''s'"));
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

TEST(LinePlot, StackedPanelsShareTheirTimeAndItsLabel)
{
    LinePlot plot = *probe_plot(probe_table(), "P_1");
    plot.panels[0].curves[0].x = {0.1, 0.2, 0.5};
    const std::string script = plot_drawing(plot, "a.png").commands;
    std::size_t ranges = 0;
    for (std::size_t at = script.find("set xrange [0:0.5]"); at != std::string::npos;
         at = script.find("set xrange [0:0.5]", at + 1))
        ++ranges;
    EXPECT_EQ(ranges, plot.panels.size());
    EXPECT_EQ(script.find("'Time [s]'"), script.rfind("'Time [s]'"));
}

TEST(PlotPanel, ScalesAndKeysAreAsAskedFor)
{
    PlotPanel panel{"stress", "strain", {{"sand", {}, {10.0, 300.0}, {0.0, 4.0}}}};
    const PixelBox box{100.0, 100.0, 560.0, 400.0};
    EXPECT_TRUE(contains(panel_commands(panel, box), "unset logscale x\nset xtics 50\n"));
    EXPECT_TRUE(contains(panel_commands(panel, box), "set key at graph 1.0, graph 1.01 "));
    panel.x_scale = AxisScale::logarithmic;
    panel.y_scale = AxisScale::downward;
    panel.key = KeyPlace::lower_right;
    EXPECT_TRUE(contains(panel_commands(panel, box), "set logscale x 10\nset xtics (10,20,50,100,200,500)"));
    EXPECT_TRUE(contains(panel_commands(panel, box), "set yrange [*:*] reverse\n"));
    EXPECT_TRUE(contains(panel_commands(panel, box), "set key bottom right "));
    panel.x_scale = AxisScale::series;
    EXPECT_TRUE(contains(panel_commands(panel, box), "set xtics (10,300)"));
    // Room for a key inside the axes.
    panel.y_scale = AxisScale::linear;
    panel.key = KeyPlace::upper_left;
    EXPECT_TRUE(contains(panel_commands(panel, box), "set yrange [-0.12:4.41989] noreverse"));
}

} // namespace quicksand
