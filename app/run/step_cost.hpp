// The bodies of benchmarks, and what a step of one costs, measured.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/journal.hpp"
#include "app/run/scene_setup.hpp"
#include "solver/base/phase_timers.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// The body of a scene at the start of its shaking; `overrides` come after those of the choice. Throws
/// InputError.
SceneSetup set_up_body(const BenchChoice& choice, const std::filesystem::path& scene,
                       const std::vector<std::string>& overrides, Journal& journal);

/// The first scene of the choice, or the dike example.
std::filesystem::path only_scene(const BenchChoice& choice);

/// Wall time of a step and of its phases, what they execute, and the memory of the step.
struct StepCost {
    double total = 0.0;     // [s]
    double time_step = 0.0; // of the motion [s]
    double resident = 0.0;  // memory of the process while it takes steps, see resident_bytes [byte]
    PhaseTimers phases;     // its instructions on one thread, where the machine counts them
};

/// Runs that a measured cost is the median of.
inline constexpr int measured_runs = 5;

/// Steps of a measured run that take about a third of a second for a body of this size.
int steps_of_a_run(std::size_t particles);

/// Cost of a step of the body, after some steps of warming up, at its stable time step. The body goes on: a
/// copy of its own would count as memory.
StepCost measure_step(const Problem& problem, int threads, State& state);

} // namespace quicksand
