#include "io/pictures/plot_panel.hpp"

#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace quicksand {
namespace {

std::string data_blocks(const std::vector<PlotCurve>& curves)
{
    std::string script;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        script += fmt::format("$curve_{} << end_of_data\n", c);
        for (std::size_t k = 0; k < std::min(curves[c].x.size(), curves[c].y.size()); ++k)
            script += gnuplot_number(curves[c].x[k]) + ' ' + gnuplot_number(curves[c].y[k]) + '\n';
        script += "end_of_data\n";
    }
    return script;
}

std::string range_words(const char* axis, const std::optional<PlotRange>& range, const char* direction)
{
    const std::string limits = range ? gnuplot_number(range->low) + ':' + gnuplot_number(range->high) : "*:*";
    return fmt::format("set {}range [{}] {}\n", axis, limits, direction);
}

/// 1, 2 and 5 times the powers of ten, which alone are too few on a few decades.
std::string logarithmic_ticks(const std::optional<PlotRange>& values)
{
    constexpr double most = 1e5; // that the labels have room for [-]
    if (!values || !(values->low > 0.0) || values->high / values->low > most) return "autofreq";
    std::string ticks;
    for (double decade = std::floor(std::log10(values->low)); decade <= std::log10(values->high);
         decade += 1.0)
        for (const double digit : {1.0, 2.0, 5.0})
            ticks += (ticks.empty() ? "(" : ",") + gnuplot_number(digit * std::pow(10.0, decade));
    return ticks + ")";
}

std::string series_ticks(const std::vector<PlotCurve>& curves, std::vector<double> PlotCurve::*coordinate)
{
    std::set<double> values;
    for (const PlotCurve& curve : curves)
        values.insert((curve.*coordinate).begin(), (curve.*coordinate).end());
    std::string ticks = "()";
    for (const double value : values)
        ticks.insert(ticks.size() - 1, (ticks == "()" ? "" : ",") + gnuplot_number(value));
    return ticks;
}

/// Scale, range and ticks, whose labels have room for `at_most`.
std::string axis_words(const char* axis, AxisScale scale, std::optional<PlotRange> range,
                       const std::vector<PlotCurve>& curves, std::vector<double> PlotCurve::*coordinate,
                       int at_most)
{
    constexpr double room = 1.15; // beside the first and the last value of a logarithmic axis
    const std::optional<PlotRange> values = range ? range : values_of(curves, coordinate);
    const bool logarithmic = scale == AxisScale::logarithmic || scale == AxisScale::series;
    std::string ticks = "autofreq";
    if (scale == AxisScale::logarithmic) ticks = logarithmic_ticks(values);
    if (scale == AxisScale::series) ticks = series_ticks(curves, coordinate);
    if (!logarithmic && values) ticks = fmt::format("{:g}", nice_ticks(*values, at_most).step);
    if (logarithmic && !range && values && values->low > 0.0)
        range = PlotRange{values->low / room, values->high * room};
    return fmt::format("{} logscale {}{}\nset {}tics {}\n", logarithmic ? "set" : "unset", axis,
                       logarithmic ? " 10" : "", axis, ticks) +
           range_words(axis, range, scale == AxisScale::downward ? "reverse" : "noreverse");
}

/// The y range: that asked for, or around the values with room above them for a key that stands there.
std::optional<PlotRange> y_range(const PlotPanel& panel)
{
    const bool key_on_top = panel.key == KeyPlace::upper_left || panel.key == KeyPlace::upper_right;
    if (panel.y_range || panel.y_scale != AxisScale::linear || !key_on_top) return panel.y_range;
    const std::optional<PlotRange> values = values_of(panel.curves, &PlotCurve::y);
    const auto names = static_cast<double>(std::count_if(
        panel.curves.begin(), panel.curves.end(), [](const auto& curve) { return !curve.name.empty(); }));
    if (!values || names == 0.0) return std::nullopt;
    constexpr double name_height = 0.055; // of the panel
    const double room = std::min(0.6, 0.04 + name_height * names);
    return PlotRange{values->low - 0.03 * values->width(),
                     values->high + values->width() * room / (1.0 - room)};
}

std::string key_words(KeyPlace place)
{
    const std::string inside = "vertical samplen 1.6 spacing 1.1 opaque width 1 font ',10'";
    switch (place) {
    case KeyPlace::above:
        return "at graph 1.0, graph 1.01 right bottom horizontal samplen 2";
    case KeyPlace::beside:
        return "at graph 1.02, graph 1.0 left top vertical Left reverse samplen 2";
    case KeyPlace::upper_left:
        return "top left Left reverse " + inside;
    case KeyPlace::upper_right:
        return "top right Right noreverse " + inside;
    case KeyPlace::lower_right:
        return "bottom right Right noreverse " + inside;
    }
    ENSURE(false);
}

std::string style_words(const PlotCurve& curve)
{
    const std::string colour = hex_code(curve.colour);
    switch (curve.style) {
    case CurveStyle::line:
        return fmt::format("lines lw 1.7 lc rgb '{}'", colour);
    case CurveStyle::line_with_points:
        return fmt::format("linespoints lw 1.7 pt 7 ps 1 lc rgb '{}'", colour);
    case CurveStyle::dashed:
        return fmt::format("lines lw 1.2 dashtype 2 lc rgb '{}'", colour);
    case CurveStyle::points:
        return fmt::format("points pt 4 ps 1.5 lw 1.8 lc rgb '{}'", colour);
    }
    ENSURE(false);
}

int room_for_ticks(double length, double each, int most)
{
    return std::clamp(static_cast<int>(length / each), 2, most);
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

std::optional<PlotRange> values_of(const std::vector<PlotCurve>& curves,
                                   std::vector<double> PlotCurve::*coordinate)
{
    PlotRange range{INFINITY, -INFINITY};
    for (const PlotCurve& curve : curves)
        for (const double value : curve.*coordinate)
            if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
    constexpr double rounding = 1e-8; // of the values: a course that differs by less is constant
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    return range.high - range.low > rounding * size ? std::optional(range) : std::nullopt;
}

std::string panel_commands(const PlotPanel& panel, const PixelBox& box)
{
    std::string script = data_blocks(panel.curves) + axes_in(box);
    script += label_at(box.left, box.top - 20.0, panel.heading, "font ':Bold,12'");
    script += fmt::format("set format x '{}'\nset format y '%g'\n", panel.x_label.empty() ? "" : "%g");
    script += fmt::format("set xlabel {} offset 0,-0.3\nset ylabel {}\n", gnuplot_text(panel.x_label),
                          gnuplot_text(panel.y_label));
    script += axis_words("x", panel.x_scale, panel.x_range, panel.curves, &PlotCurve::x,
                         room_for_ticks(box.width, 75.0, 14));
    script += axis_words("y", panel.y_scale, y_range(panel), panel.curves, &PlotCurve::y,
                         room_for_ticks(box.height, 34.0, 9));
    script += "set key default\nset key " + key_words(panel.key) + "\nplot ";
    if (panel.curves.empty()) script += "NaN notitle"; // the axes alone
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        const PlotCurve& curve = panel.curves[c];
        script += fmt::format("{}$curve_{} using 1:2 with {} {}", c == 0 ? "" : ", \\\n     ", c,
                              style_words(curve),
                              curve.name.empty() ? "notitle" : "title " + gnuplot_text(curve.name));
    }
    return script + "\nunset label\nunset arrow\n";
}

} // namespace quicksand
