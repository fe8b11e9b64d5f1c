// The panels of an element test's page, each with the name of its picture.
#pragma once

#include "io/element/element_outcome.hpp"
#include "io/pictures/plot_panel.hpp"

#include <string>
#include <vector>

namespace quicksand {

struct NamedPanel {
    std::string name; // "loops"
    PlotPanel panel;
};

std::vector<NamedPanel> element_panels(const ElementOutcome& outcome);

} // namespace quicksand
