// The figures of a scene: which curves they hold, in which units and scale.
#include "io/pictures/figure_set.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

SceneFigure figure_of(std::string_view name, double scale)
{
    SceneFigure figure;
    figure.quantity = find_figure_quantity(name);
    figure.scale = scale;
    return figure;
}

const FigureProbe gauge{"gauge",
                        {{},
                         {"time_s", "uy_m", "excess_pore_pressure_Pa", "vertical_effective_stress_Pa"},
                         {{0.0, 0.1, 0.2}, {0.0, -1e-3, -2e-3}, {0.0, 5e4, 1e5}, {1.2e5, 7e4, 2e4}}}};

TEST(HistoryFigure, DrawsPressuresWithTheStressTheyMayReach)
{
    const auto plot = history_figure(figure_of("excess_pore_pressure", 120.0), {gauge});
    ASSERT_TRUE(plot);
    const std::vector<PlotCurve>& curves = plot->panels.front().curves;
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_EQ(plot->panels.front().y_label, "Excess pore pressure [kPa]");
    EXPECT_DOUBLE_EQ(curves[0].x[2], 24.0);
    EXPECT_DOUBLE_EQ(curves[0].y[2], 100.0);
    EXPECT_EQ(curves[1].style, CurveStyle::dashed);
    EXPECT_DOUBLE_EQ(curves[1].y[0], 120.0);
    EXPECT_DOUBLE_EQ(curves[1].x[1], 24.0);
}

TEST(HistoryFigure, CountsSettlementDownwardInFullScale)
{
    const auto plot = history_figure(figure_of("settlement", 120.0), {gauge});
    ASSERT_TRUE(plot);
    const PlotCurve& curve = plot->panels.front().curves.front();
    EXPECT_EQ(plot->panels.front().curves.size(), 1U);
    EXPECT_EQ(plot->panels.front().y_label, "Settlement [mm]");
    EXPECT_NEAR(curve.y[2], 240.0, 1e-9);
    EXPECT_FALSE(history_figure(figure_of("ru", 1.0), {gauge}));
}

TEST(IsochroneFigure, TakesTheProfilesNearestToItsTimes)
{
    SceneFigure figure = figure_of("mean_effective_stress", 10.0);
    figure.kind = FigureKind::isochrones;
    figure.times = {0.0, 0.19};
    const FigureProbe line{"line",
                           {{},
                            {"time_s", "distance_m", "x_m", "y_m", "mean_effective_stress_Pa"},
                            {{0.0, 0.0, 0.1, 0.1, 0.2, 0.2},
                             {0.0, 1.0, 0.0, 1.0, 0.0, 1.0},
                             {0.5, 0.5, 0.5, 0.5, 0.5, 0.5},
                             {2.0, 3.0, 2.0, 3.0, 2.0, 3.0},
                             {9e3, 5e3, 8e3, 4e3, 7e3, 3e3}}}};
    const auto plot = isochrone_figure(figure, line);
    ASSERT_TRUE(plot);
    const PlotPanel& panel = plot->panels.front();
    ASSERT_EQ(panel.curves.size(), 2U);
    EXPECT_EQ(panel.y_label, "Height y [m]");
    EXPECT_EQ(panel.curves[1].name, "t = 2 s");
    EXPECT_DOUBLE_EQ(panel.curves[1].x[0], 7.0);
    EXPECT_DOUBLE_EQ(panel.curves[1].y[1], 30.0);
}

TEST(DrawFigures, NamesTheProbeThatTheRunHadNot)
{
    const fixtures::TemporaryFolder folder;
    SceneFigure figure = figure_of("settlement", 1.0);
    figure.name = "crest";
    figure.probes = {"gauge"};
    try {
        draw_figures(folder.path(), {figure}, folder / "figures", [](const std::string&) {});
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "figure crest: the results have no " + (folder / "probes/gauge.csv").string() +
                      "\nhint: the scene of the run had no such probe; run it again");
    }
}

TEST(DrawFigures, LeavesAFigureWithoutValuesOutAndSaysSo)
{
    const fixtures::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "probes");
    std::ofstream(folder / "probes/gauge.csv") << "time_s,ux_m\n0,0\n0.1,0\n";
    SceneFigure figure = figure_of("ru", 1.0);
    figure.name = "ratio";
    figure.probes = {"gauge"};
    std::string remark;
    const auto files = draw_figures(folder.path(), {figure}, folder / "figures",
                                    [&](const std::string& text) { remark = text; });
    EXPECT_TRUE(files.empty());
    EXPECT_EQ(remark, "figure ratio: the results have no values of it");
}

TEST(DrawFigures, NeedAFolder)
{
    try {
        draw_figures("results", {}, "/proc/quicksand/figures", [](const std::string&) {});
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "/proc/quicksand/figures: cannot make the folder: No such file or directory");
    }
}

} // namespace
} // namespace quicksand
