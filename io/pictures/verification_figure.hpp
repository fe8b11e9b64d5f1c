// Error against resolution of one verified problem, as a figure with logarithmic axes.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "solver/verification/solutions/convergence.hpp"

#include <vector>

namespace quicksand {

/// The curves of one problem (a gap where a run failed), with dashed lines of slope 1 and 2 from the
/// coarsest grid.
LinePlot convergence_plot(const std::vector<Convergence>& problem);

} // namespace quicksand
