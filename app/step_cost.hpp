// What a step of a body costs, measured.
#pragma once

#include "solver/phase_timers.hpp"
#include "solver/problem.hpp"
#include "solver/state.hpp"

namespace quicksand {

/// Wall time of a step and of its phases [s].
struct StepCost {
    double total = 0.0;
    PhaseTimers phases;
};

/// Runs that a measured cost is the median of.
inline constexpr int measured_runs = 5;

/// Steps of a measured run that take about a third of a second for a body of this size.
int steps_of_a_run(std::size_t particles);

/// Cost of a step of the body, after some steps of warming up, at its stable time step.
StepCost measure_step(const Problem& problem, State state, int threads);

} // namespace quicksand
