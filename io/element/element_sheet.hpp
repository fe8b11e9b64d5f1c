// The pages of element tests: what is drawn of each kind.
#pragma once

#include "io/element/element_outcome.hpp"
#include "io/element/element_results.hpp"
#include "io/element/laboratory_sheet.hpp"

namespace quicksand {

/// The page of a test: loops, stress path, pore pressure, strength, whatever its kind has, and a table.
LaboratorySheet report_sheet(const ElementOutcome& outcome, const std::string& title);

/// Draw report.png, and every panel of it as a picture of its own. Throws FileError.
void draw_element_pictures(const ElementOutcome& outcome, const std::string& title, ElementResults& results);

} // namespace quicksand
