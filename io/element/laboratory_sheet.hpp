// A page like a laboratory's report: a heading with material and conditions, panels in two columns, and a
// table of results.
#pragma once

#include "io/pictures/plot_panel.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

struct LaboratorySheet {
    std::string title;
    std::vector<std::string> details; // lines of the heading
    std::vector<PlotPanel> panels;    // row by row
    std::vector<std::string> table;   // lines in a typewriter face, in the place after the last panel
};

/// The picture for draw_pictures().
Drawing sheet_drawing(const LaboratorySheet& sheet, const std::filesystem::path& png);

} // namespace quicksand
