// The columns of free fields go ahead with the body, step by step.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step/stepper.hpp"
#include "solver/step_length/time_step.hpp"

#include <memory>
#include <vector>

namespace quicksand {

/// Set the step_scale of the state and of its columns, see measure_bound(). Throws NumericalError.
void measure_bounds(const Problem& problem, State& state);

/// The shortest of the steps of the body and of its columns, with the bounds that were last measured.
TimeStep shortest_time_step(const Problem& problem, State& state);

/// Set the length that was chosen for the next step, before it is shortened for output [s].
void note_whole_step(double dt, State& state);

/// The steppers of the columns. They have nothing that would have to survive a checkpoint.
class FreeFieldSteps {
public:
    explicit FreeFieldSteps(const Problem& problem);

    /// Take the columns over a step of the body, before it, and find what they do to its sides in this step.
    /// Throws NumericalError.
    void advance(const Problem& problem, double dt, State& state);

    void restart();

private:
    std::vector<std::unique_ptr<Stepper>> steppers_;
};

} // namespace quicksand
