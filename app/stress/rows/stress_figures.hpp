// The figures of the laboratory's page.
#pragma once

#include "app/stress/rows/row_outcome.hpp"
#include "io/pictures/line_plot.hpp"

#include <vector>

namespace quicksand {

/// Errors, margins and run times over the rows, in their order; a colour a group.
LinePlot outcome_plot(const std::vector<RowOutcome>& outcomes);

} // namespace quicksand
