// Curves over time or height: panels above or beside each other under one heading.
#pragma once

#include "io/pictures/plot_panel.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

enum class PlotArrangement { stacked, side_by_side };

struct LinePlot {
    std::string title;
    std::string note;              // a smaller line below; may be empty
    std::vector<PlotPanel> panels; // stacked ones share the x axis
    PlotArrangement arrangement = PlotArrangement::stacked;
};

/// The picture for draw_pictures().
Drawing plot_drawing(const LinePlot& plot, const std::filesystem::path& png);

} // namespace quicksand
