// Curves over time or height as PNGs, drawn by gnuplot in a process of its own.
#pragma once

#include "io/pictures/colour_map.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

enum class CurveStyle { line, line_with_points, dashed };

/// One curve; NaN leaves a gap.
struct PlotCurve {
    std::string name; // in the key; "" for none
    Colour colour;
    std::vector<double> x, y; // in the units of the panel's labels
    CurveStyle style = CurveStyle::line;
};

enum class PlotScale { linear, logarithmic };

/// One pair of axes.
struct PlotPanel {
    std::string x_label, y_label; // with units
    std::vector<PlotCurve> curves;
    bool key_beside = false;             // the key right of the axes instead of above them
    PlotScale scale = PlotScale::linear; // of both axes
};

enum class PlotArrangement { stacked, side_by_side };

struct LinePlot {
    std::string title;
    std::string note;              // a smaller line below; may be empty
    std::vector<PlotPanel> panels; // stacked ones share the x axis
    PlotArrangement arrangement = PlotArrangement::stacked;
};

/// Colour of the k-th of `count` curves that differ in kind.
Colour curve_colour(std::size_t k, std::size_t count);

/// What gnuplot is told, data included; it writes `png`.
std::string plot_script(const LinePlot& plot, const std::filesystem::path& png);

/// Draw by way of a temporary file. Throws FileError, also where gnuplot is missing or fails.
void draw_line_plot(const LinePlot& plot, const std::filesystem::path& png);

} // namespace quicksand
