// A page like a laboratory's report: a heading with material and conditions, panels in two columns, and a
// table of results. Drawn by gnuplot.
#pragma once

#include "io/pictures/line_plot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

enum class SheetMark { line, guide, points, line_with_points };

struct SheetCurve {
    PlotCurve curve;
    SheetMark mark = SheetMark::line;
};

enum class SheetAxis { linear, logarithmic, downward };
enum class KeyCorner { upper_left, upper_right, lower_right };

struct SheetPanel {
    std::string heading;          // what is shown of which test
    std::string x_label, y_label; // with units
    std::vector<SheetCurve> curves;
    SheetAxis x_axis = SheetAxis::linear, y_axis = SheetAxis::linear;
    std::optional<std::pair<double, double>> x_range, y_range; // none: round limits around the values
    KeyCorner key = KeyCorner::upper_left;
};

struct LaboratorySheet {
    std::string title;
    std::vector<std::string> details; // lines of the heading
    std::vector<SheetPanel> panels;   // row by row
    std::vector<std::string> table;   // lines in a typewriter face, in the place after the last panel
};

struct SheetFile {
    LaboratorySheet sheet;
    std::filesystem::path png;
};

/// What gnuplot is told; it writes `png`.
std::string sheet_script(const LaboratorySheet& sheet, const std::filesystem::path& png);

/// Draw all, by way of temporary files. Throws FileError, also where gnuplot is missing or fails.
void draw_laboratory_sheets(const std::vector<SheetFile>& files);

} // namespace quicksand
