// The panels of an element test's page, each with the name of its picture.
#pragma once

#include "io/element/element_outcome.hpp"
#include "io/element/laboratory_sheet.hpp"

#include <string>
#include <vector>

namespace quicksand {

struct NamedPanel {
    std::string name; // "loops"
    SheetPanel panel;
};

std::vector<NamedPanel> element_panels(const ElementOutcome& outcome);

} // namespace quicksand
