// How much longer a step could be before random motion grows.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// The largest step at which a small random motion does not grow, over the step that the program takes, to
/// 2 %; 5 where it does not grow even there, 0 where it grows at a twentieth of the step [-]. The motion is
/// put on top of the run from a state at the start of the shaking, and taken from the difference of two runs,
/// so that what the loads move does not count. It grows when it is 30 times its size after at most 500 steps;
/// that takes a rate of 0.7 % a step.
double step_margin(const Problem& problem, const State& start);

} // namespace quicksand
