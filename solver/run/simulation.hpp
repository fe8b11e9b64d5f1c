// The run: the stages, the loop over the steps, and the observers that look on. No file access.
#pragma once

#include "solver/measure/monitors.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/unbalanced_forces.hpp"

#include <functional>
#include <vector>

namespace quicksand {

struct RelaxationControls {
    double damping = 0.7;             // local damping factor [-]
    double tolerance = 1e-6;          // out-of-balance force / body force at which the stage ends [-]
    std::int64_t max_steps = 200'000; // then the stage is a NumericalError [-]
};

/// What is told now and then while the soil settles.
struct SettlingProgress {
    std::int64_t steps = 0;      // [-]
    UnbalancedForces unbalanced; // now
};

using SettlingWatcher = std::function<void(const SettlingProgress&)>;

/// Outcome of the relaxation stage.
struct RelaxationReport {
    bool settled = false;          // false: stopped
    std::int64_t steps = 0;        // [-]
    UnbalancedForces unbalanced;   // at the end
    double max_displacement = 0.0; // how far the soil moved while settling [m]
    std::size_t at_failure = 0;    // particles whose shear stress is the largest their sand can carry [-]
};

/// Out-of-balance force / body force of the state, all forces in the norm sum_i |f_i| over the free
/// directions of the nodes; without gravity, relative to the internal forces [-].
double out_of_balance(const Problem& problem, const State& state);

/// Settle under gravity, damped and with the pore pressures held; then velocities are zero, displacements are
/// counted from the settled shape and sigma'_v0 is frozen. A state of the stage relaxation goes on where it
/// stopped. Now and then, between two steps and before the soil has settled, `progress` is called and `stop`
/// asked. Throws NumericalError; the state is then the one in which the soil was found not to settle.
RelaxationReport relax(const Problem& problem, const RelaxationControls& controls, State& state,
                       const SettlingWatcher& progress = {}, const StopRule& stop = {});

/// The problem while it settles under gravity: laws with a memory of cycles are replaced by what they are in
/// a static stage.
Problem settling_problem(const Problem& problem);

/// The start of shaking: freeze sigma'_v0 from the present stress, set the reference of displacements, and
/// let the memory of cycles begin where a material has one. Returns the number of particles whose stress was
/// beyond what their material can carry and has been brought back to it.
std::size_t begin_shaking(const Problem& problem, State& state);

/// The same for a body whose laws have no memory.
void begin_shaking(State& state);

/// Run from state.time to end_time; returns whether it is reached, false after a stop. What serves several
/// steps is set up anew at restart points: at the end, where observers look on that mark them, and every few
/// dozen steps. There `stop` is asked. Throws NumericalError.
bool run(const Problem& problem, double end_time, const std::vector<Observer*>& observers, State& state,
         const StopRule& stop = {});

} // namespace quicksand
