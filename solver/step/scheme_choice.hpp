// Which steps cost less: implicit ones, or those that waves of the skeleton limit.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/step_length/time_step.hpp"

namespace quicksand {

/// The scheme by which steps are taken that waves of the skeleton limit.
TimeScheme scheme_of_waves(const Problem& problem);

/// The problem, and the columns beyond its free-field sides, with steps of a scheme.
Problem with_scheme(const Problem& problem, TimeScheme scheme);

/// Whether the run goes on for less with steps of `by_waves` than with implicit ones of `accurate`, each of
/// which costs `cost` of them (implicit_cost.hpp).
bool are_waves_cheaper(const TimeStep& by_waves, const TimeStep& accurate, double cost);

/// The step that waves limit to `dt`, after one of `last_step`: forces act over the mean of both, and where
/// that is more than dt the step is as much shorter [s].
double step_after(double last_step, double dt);

} // namespace quicksand
