// What all rows together say: failures that no exit code tells, files that hold no numbers, margins.
#pragma once

#include "app/stress/rows/row_outcome.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// From where on balances make a run useless [-]. Sound runs lose up to 0.8 of what is put in, runs that blow
/// up tens to thousands of times that.
inline constexpr double worst_energy_error = 0.1;
inline constexpr double worst_water_error = 0.01;
inline constexpr double worst_loss = 2.0;
/// The largest stable step over the own one: less has no margin, more wastes time [-].
inline constexpr double least_margin = 1.02, most_margin = 1.5;
/// Displacements of twins that agree, over the larger one [-].
inline constexpr double most_disagreement = 0.05;

/// A run that is told to be good and is not: exit code 0 with an energy or water error beyond what is of use,
/// or more energy lost numerically than was ever put in.
bool is_silent(const RowOutcome& outcome);

/// It stopped, crashed or went on for too long, or its balances are bad, at a step that the program chose.
bool is_failure(const RowOutcome& outcome);

/// It reached its end with a shorter step than the one that the program chose.
bool was_halved(const RowOutcome& outcome);

/// Faster than its boundaries can make it: at rest for most of the rows that have a limit.
bool is_too_fast(const RowOutcome& outcome);

bool has_poor_margin(const RowOutcome& outcome);

/// Compare the displacements of twins that both ended well.
void compare_twins(std::vector<RowOutcome>& outcomes);

struct StressSummary {
    std::size_t rows = 0;
    std::vector<std::size_t> ends; // rows by RowEnd
    std::vector<std::string> silent, failures, unreadable, too_fast, halved, poor_margins,
        disagreeing; // "row: what"
};

StressSummary summarize(const std::vector<RowOutcome>& outcomes);

} // namespace quicksand
