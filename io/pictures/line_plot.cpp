#include "io/pictures/line_plot.hpp"

#include "io/files/atomic_file.hpp"
#include "io/pictures/picture_gnuplot.hpp"
#include "io/pictures/picture_ticks.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace quicksand {
namespace {

// Sizes of the sheet and its margins [pixel].
constexpr double stack_width = 1200.0, stack_panel = 170.0, stack_alone = 430.0, stack_gap = 46.0;
constexpr double beside_width = 600.0, beside_panel = 560.0;
constexpr double left_margin = 112.0, right_margin = 36.0, top_margin = 120.0, bottom_margin = 76.0;
// Right of the axes where the key stands beside them: its samples, and a letter of a name.
constexpr double key_samples = 76.0, key_letter = 8.3, least_key = 210.0;

struct Box {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0; // from the upper left corner [pixel]
};

struct Sheet {
    double width = 0.0, height = 0.0; // [pixel]
    std::vector<Box> boxes;           // of the panels
};

double margin_for_keys(const LinePlot& plot)
{
    double margin = right_margin;
    for (const PlotPanel& panel : plot.panels) {
        if (!panel.key_beside) continue;
        margin = std::max(margin, least_key);
        for (const PlotCurve& curve : panel.curves)
            margin = std::max(margin, key_samples + key_letter * static_cast<double>(curve.name.size()));
    }
    return margin;
}

Sheet lay_out(const LinePlot& plot)
{
    Sheet sheet;
    const auto count = static_cast<double>(plot.panels.size());
    const double right = margin_for_keys(plot);
    if (plot.arrangement == PlotArrangement::stacked) {
        const double panel = count > 1.0 ? stack_panel : stack_alone;
        sheet.width = stack_width;
        sheet.height = top_margin + count * panel + (count - 1.0) * stack_gap + bottom_margin;
        for (double top = top_margin; sheet.boxes.size() < plot.panels.size(); top += panel + stack_gap)
            sheet.boxes.push_back({left_margin, stack_width - right, top, top + panel});
        return sheet;
    }
    sheet.width = count * beside_width + (right - right_margin);
    sheet.height = top_margin + beside_panel + bottom_margin;
    for (double left = 0.0; sheet.boxes.size() < plot.panels.size(); left += beside_width)
        sheet.boxes.push_back(
            {left + left_margin, left + beside_width - right_margin, top_margin, top_margin + beside_panel});
    return sheet;
}

std::string data_blocks(const LinePlot& plot)
{
    std::string script;
    for (std::size_t p = 0; p < plot.panels.size(); ++p)
        for (std::size_t c = 0; c < plot.panels[p].curves.size(); ++c) {
            const PlotCurve& curve = plot.panels[p].curves[c];
            script += fmt::format("$curve_{}_{} << end_of_data\n", p, c);
            for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k)
                script += fmt::format("{} {}\n", gnuplot_number(curve.x[k]), gnuplot_number(curve.y[k]));
            script += "end_of_data\n";
        }
    return script;
}

std::string heading(const LinePlot& plot, const Sheet& sheet)
{
    const auto label = [&](int tag, const std::string& text, double from_top, const char* style) {
        return fmt::format("set label {} {} at screen {:.5f}, screen {:.5f} left {}\n", tag,
                           gnuplot_text(text), left_margin / sheet.width, 1.0 - from_top / sheet.height,
                           style);
    };
    return label(1, plot.title, 34.0, "font ':Bold,16'") +
           label(2, plot.note, 62.0, "font ',11' textcolor rgb '#606060'");
}

/// Ticks that leave room between their labels; gnuplot's own choice where the values are all the same.
std::string tick_step(const char* axis, const std::vector<PlotCurve>& curves,
                      std::vector<double> PlotCurve::*values, int at_most)
{
    double low = INFINITY, high = -INFINITY;
    for (const PlotCurve& curve : curves)
        for (const double value : curve.*values)
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    if (!(high > low)) return fmt::format("set {}tics autofreq\n", axis);
    return fmt::format("set {}tics {:g}\n", axis, nice_ticks({low, high}, at_most).step);
}

/// Where panels are stacked the y label lies above its axes, where long ones have room; else beside them.
std::string y_label(const PlotPanel& panel, const Box& box, bool stacked, const Sheet& sheet)
{
    if (!stacked) return fmt::format("set ylabel {}\n", gnuplot_text(panel.y_label));
    return fmt::format("set label 3 {} at screen {:.5f}, screen {:.5f} left\n", gnuplot_text(panel.y_label),
                       box.left / sheet.width, 1.0 - (box.top - 13.0) / sheet.height);
}

/// Ticks at the values of x themselves, which are few: the grids of a series.
std::string logarithmic_axes(const std::vector<PlotCurve>& curves)
{
    std::set<double> values;
    for (const PlotCurve& curve : curves) values.insert(curve.x.begin(), curve.x.end());
    std::string ticks;
    for (const double value : values) ticks += (ticks.empty() ? "" : ",") + gnuplot_number(value);
    constexpr double room = 1.15; // beside the first and the last
    return fmt::format("set logscale xy 10\nset xrange [{}:{}]\nset xtics ({})\nset ytics autofreq\n"
                       "set format y '%g'\nset mytics 10\n",
                       gnuplot_number(*values.begin() / room), gnuplot_number(*values.rbegin() * room),
                       ticks);
}

std::string style_of(const PlotCurve& curve)
{
    const std::string colour = hex_code(curve.colour);
    switch (curve.style) {
    case CurveStyle::line:
        return fmt::format("lines lw 1.8 lc rgb '{}'", colour);
    case CurveStyle::line_with_points:
        return fmt::format("linespoints lw 1.8 pt 7 ps 1.1 lc rgb '{}'", colour);
    case CurveStyle::dashed:
        return fmt::format("lines lw 1.2 dashtype 2 lc rgb '{}'", colour);
    }
    ENSURE(false);
}

std::string panel_commands(const LinePlot& plot, std::size_t p, const Sheet& sheet)
{
    const PlotPanel& panel = plot.panels[p];
    const Box& box = sheet.boxes[p];
    const bool stacked = plot.arrangement == PlotArrangement::stacked;
    const bool shows_x = !stacked || p + 1 == plot.panels.size();
    std::string script = fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
                                     "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                                     box.left / sheet.width, box.right / sheet.width,
                                     1.0 - box.top / sheet.height, 1.0 - box.bottom / sheet.height);
    script += fmt::format("set format x {}\n", shows_x ? "'%g'" : "''");
    script += fmt::format("set xlabel {} offset 0,-0.3\n", shows_x ? gnuplot_text(panel.x_label) : "''");
    script += y_label(panel, box, stacked, sheet);
    if (panel.scale == PlotScale::logarithmic) {
        script += logarithmic_axes(panel.curves);
    } else {
        script += tick_step("y", panel.curves, &PlotCurve::y, stacked && plot.panels.size() > 1 ? 5 : 9);
        if (!stacked) script += tick_step("x", panel.curves, &PlotCurve::x, 6);
    }
    script += panel.key_beside ? "set key at graph 1.02, graph 1.0 left top vertical Left reverse samplen 2\n"
                               : "set key at graph 1.0, graph 1.01 right bottom horizontal samplen 2\n";
    std::string separator = "plot ";
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        const PlotCurve& curve = panel.curves[c];
        script += fmt::format("{}$curve_{}_{} using 1:2 with {} {}", separator, p, c, style_of(curve),
                              curve.name.empty() ? "notitle" : "title " + gnuplot_text(curve.name));
        separator = ", \\\n     ";
    }
    if (panel.scale == PlotScale::logarithmic) script += "\nunset logscale xy\nset autoscale";
    return script + "\nunset label 1\nunset label 2\nunset label 3\n";
}

} // namespace

Colour curve_colour(std::size_t k, std::size_t count)
{
    // The palette of M. Okabe and K. Ito, which colour-blind readers can tell apart.
    constexpr std::array<Colour, 7> palette{{{0.000, 0.447, 0.698},
                                             {0.835, 0.369, 0.000},
                                             {0.000, 0.620, 0.451},
                                             {0.800, 0.475, 0.655},
                                             {0.337, 0.706, 0.914},
                                             {0.902, 0.624, 0.000},
                                             {0.150, 0.150, 0.150}}};
    if (count <= palette.size()) return palette[k % palette.size()];
    // The palest tenth of the map is hard to see on white.
    return map_colour(ColourMap::sequential, 0.9 * static_cast<double>(k) / static_cast<double>(count - 1));
}

std::string plot_script(const LinePlot& plot, const std::filesystem::path& png)
{
    const Sheet sheet = lay_out(plot);
    std::string script = fmt::format("set encoding utf8\n"
                                     "set terminal pngcairo noenhanced size {:.0f},{:.0f} "
                                     "font 'DejaVu Sans,12' background rgb '#ffffff'\n"
                                     "set output {}\n",
                                     sheet.width, sheet.height, gnuplot_text(png.string()));
    script += "set minussign\n"
              "set border 15 lw 1 lc rgb '#303030'\n"
              "set tics out nomirror scale 0.6 textcolor rgb '#1a1a1a'\n"
              "set grid lt 1 lw 0.7 lc rgb '#dddddd'\n";
    if (plot.arrangement == PlotArrangement::stacked) script += "set autoscale xfix\n";
    script += data_blocks(plot);
    script += "set multiplot\n" + heading(plot, sheet);
    for (std::size_t p = 0; p < plot.panels.size(); ++p) script += panel_commands(plot, p, sheet);
    return script + "unset multiplot\nunset output\n";
}

void draw_line_plot(const LinePlot& plot, const std::filesystem::path& png)
{
    run_gnuplot(plot_script(plot, temporary_name(png)), png);
    replace_file(png);
}

} // namespace quicksand
