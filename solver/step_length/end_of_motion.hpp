// When nothing moves the soil with waves any more.
//
// That is the end of shaking and of all histories, but not of slow ones: what rises over a hundred times the
// time in which shear waves rise through the grid, as a flood or a tide, moves the soil without waves. What
// shaking and loads leave of the vibration of the body is followed on, for some periods of it
// (own_vibration.hpp): it compacts sand.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step_length/cell_extremes.hpp"

namespace quicksand {

/// Time in which shear waves of the speed `shear_speed` [m/s] rise from the base of the grid to its top [s].
double crossing_time(const BackgroundGrid& grid, double shear_speed);

/// Whether a history rises or falls so slowly that it moves the soil without waves; what comes at once does
/// not.
bool is_slow(const History& history, double crossing_time);

/// Whether a load makes waves: it comes at once, or rises fast.
bool is_loaded_fast(const Problem& problem, double crossing_time);

/// Whether something on the boundaries changes, and slowly.
bool changes_slowly(const Problem& problem, double crossing_time);

/// Time from which nothing moves the soil with waves any more, but its own vibration; infinite for a fast
/// sine without end [s].
double end_of_motion(const Problem& problem, double crossing_time);

/// Whether that has passed at a time, and the soil no longer vibrates, or has for long enough.
bool is_left_alone(const Problem& problem, double time, const Particles& particles,
                   const CellExtremes& extremes);

/// The same of a state.
bool is_left_alone(const Problem& problem, const State& state);

} // namespace quicksand
