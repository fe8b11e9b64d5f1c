// The step of a run, bounded by the vibration of its nodes.
//
// Closed forms (time_step_control.hpp) follow the waves of every material from step to step. They do not know
// nearly empty cells, interfaces, walls, or motions that change the volume of no cell and meet no water. The
// nodes' own equations do. Their limit is measured at the start of the shaking and every so many steps.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <cstdint>

namespace quicksand {

/// Steps from one measurement to the next: it costs as much as some twenty steps.
inline constexpr std::int64_t steps_between_bounds = 2048;

/// Below it vibrations do not shorten the step, and the watchdog decides. Waves of the volume in nearly
/// incompressible soil, which change the volume of no cell, are faster than the shear wave of the closed form
/// by sqrt(M/G): 0.2 for Poisson's ratio of 0.49, 0.03 for 0.4999 [-].
inline constexpr double least_step_scale = 0.02;

/// step_scale of a run of implicit steps, until it is measured for the steps that waves limit in it; and
/// implicit_cost, until it is counted [-].
inline constexpr double not_measured = 0.0;

/// Set the state's step_scale: 0.9 of the limit of the nodes' vibration over the step of the closed forms, at
/// most 1 and at least least_step_scale; not_measured where steps are implicit, and their cost not counted.
/// Throws NumericalError.
void measure_bound(const Problem& problem, State& state);

/// The step from the state, with the bound that was last measured.
TimeStep bounded_time_step(const Problem& problem, const State& state);

/// The same with the bound measured for it. Throws NumericalError.
TimeStep measure_time_step(const Problem& problem, const State& state);

} // namespace quicksand
