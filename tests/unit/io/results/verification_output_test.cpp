// The files of verify: its table and its figures.
#include "io/pictures/verification_figure.hpp"
#include "io/results/verification_csv.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace quicksand {
namespace {

Convergence measured()
{
    constexpr double none = std::numeric_limits<double>::infinity();
    Convergence result;
    result.problem = "column";
    result.title = "Waves of a column";
    result.length = 1.0;
    result.quantity = "speed, \"fast\"";
    result.norm = "relative";
    result.reference = "Biot 1956";
    result.cells = {10, 20};
    result.errors = {0.5, 0.125};
    result.limits = {none, 0.25};
    result.seconds = {1.0, 2.0};
    return result;
}

TEST(VerificationCsv, HasARowForEachGridAndQuotesItsTexts)
{
    const fixtures::TemporaryFolder folder;
    write_verification_csv(folder / "table.csv", {measured()});
    std::ifstream stream(folder / "table.csv");
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_EQ(text, "problem,quantity,norm,cells,error,limit,order,least_order,seconds,reference\n"
                    "\"column\",\"speed, \"\"fast\"\"\",\"relative\",10,0.5,,2,,1,\"Biot 1956\"\n"
                    "\"column\",\"speed, \"\"fast\"\"\",\"relative\",20,0.125,0.25,2,,2,\"Biot 1956\"\n");
}

TEST(ConvergencePlot, HasLogarithmicAxesAndLinesOfSlope)
{
    const LinePlot plot = convergence_plot({measured()});
    EXPECT_EQ(plot.title, "Waves of a column: error against resolution");
    EXPECT_EQ(plot.panels.at(0).x_label, "cells along 1 m");
    ASSERT_EQ(plot.panels.size(), 1u);
    ASSERT_EQ(plot.panels[0].curves.size(), 3u);
    EXPECT_EQ(plot.panels[0].curves[0].name, "speed, \"fast\", order 2.00");
    EXPECT_EQ(plot.panels[0].curves[1].y, (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(plot.panels[0].curves[2].y, (std::vector<double>{0.5, 0.125}));
    const std::string script = plot_drawing(plot, "out.png").commands;
    EXPECT_NE(script.find("set logscale x 10\nset xtics (10,20)"), std::string::npos);
    EXPECT_NE(script.find("set logscale y 10\nset ytics (0.1,0.2,0.5)"), std::string::npos);
    EXPECT_NE(script.find("linespoints"), std::string::npos);
    EXPECT_NE(script.find("dashtype 2"), std::string::npos);
}

TEST(ConvergencePlot, LeavesAGapWhereARunWentBad)
{
    Convergence failed = measured();
    failed.errors = {std::numeric_limits<double>::infinity(), 0.125};
    const LinePlot plot = convergence_plot({measured(), failed});
    EXPECT_TRUE(std::isnan(plot.panels.at(0).curves.at(1).y.at(0)));
    EXPECT_EQ(plot.panels[0].curves[2].y, (std::vector<double>{0.5, 0.25})); // slope 1
}

} // namespace
} // namespace quicksand
