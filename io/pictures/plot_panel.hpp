// One pair of axes with curves, in gnuplot's words.
#pragma once

#include "io/pictures/colour_map.hpp"
#include "io/pictures/picture_gnuplot.hpp"
#include "io/pictures/picture_ticks.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

enum class CurveStyle { line, line_with_points, dashed, points };

/// One curve; NaN leaves a gap.
struct PlotCurve {
    std::string name; // in the key; "" for none
    Colour colour;
    std::vector<double> x, y; // in the units of the panel's labels
    CurveStyle style = CurveStyle::line;
};

/// A series is logarithmic too, with ticks at the values themselves, which are few: the grids of a study.
enum class AxisScale { linear, downward, logarithmic, series };

enum class KeyPlace { above, beside, upper_left, upper_right, lower_right };

struct PlotPanel {
    std::string x_label, y_label; // with units; without its label the x axis has no numbers either
    std::vector<PlotCurve> curves;
    KeyPlace key = KeyPlace::above;
    AxisScale x_scale = AxisScale::linear, y_scale = AxisScale::linear;
    std::optional<PlotRange> x_range = {}, y_range = {}; // none: round limits around the values
    std::string heading = {};                            // above the axes; may be empty
};

/// Colour of the k-th of `count` curves that differ in kind.
Colour curve_colour(std::size_t k, std::size_t count);

/// From the least to the largest finite value of the curves; none where they differ by rounding at most.
std::optional<PlotRange> values_of(const std::vector<PlotCurve>& curves,
                                   std::vector<double> PlotCurve::*coordinate);

/// Draw the panel, data included, with its axes filling the box, inside a multiplot.
std::string panel_commands(const PlotPanel& panel, const PixelBox& box);

} // namespace quicksand
