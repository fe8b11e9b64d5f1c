// Steps that waves limit within a run of implicit ones.
//
// While something moves the soil, accuracy may leave implicit steps so short that steps that waves limit, and
// of which each costs less, are faster. They are then taken to the next restart point.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step_length/time_step.hpp"

#include <optional>

namespace quicksand {

/// The implicit step from the state in whose place steps of `wave_form`, the problem with the scheme of
/// waves, are to be taken; none where implicit steps are:
///   once nothing moves the soil any more and it does not flow: they grow, and damp vibrations
///   after a failure, to the next restart point
/// Measures the bound of the steps of waves, and counts the cost of implicit ones, where they are considered
/// for the first time since measure_bounds().
/// Throws NumericalError.
std::optional<TimeStep> step_replaced_by_waves(const Problem& problem, const Problem& wave_form,
                                               State& state);

/// The step with which a run from the state begins. Throws NumericalError.
TimeStep first_time_step(const Problem& problem, State state);

} // namespace quicksand
