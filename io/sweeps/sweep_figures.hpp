// A sweep's picture: how far the soil moves, over each varied key.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "io/sweeps/sweep_outcomes.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Axis of a varied key: its values as they are shown, by run; a text's is its number among the texts.
struct KeyAxis {
    std::string label;
    std::vector<double> values;
    double factor = 1.0; // SI unit over the shown one
};

KeyAxis axis_of(const Sweep& sweep, std::size_t varied, const std::vector<SweepOutcome>& outcomes);

/// Peak of the crest settlement, or of the largest displacement where no run has one, over each varied key,
/// three in a plot. None where no run has a value.
std::vector<LinePlot> sweep_plots(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes);

} // namespace quicksand
