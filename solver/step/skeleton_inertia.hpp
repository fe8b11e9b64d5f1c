// The force with which the skeleton's stiffness resists accelerations, - beta dt K (v' - v), in a step that
// is under way (inertia_solve.hpp).
#pragma once

#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"

namespace quicksand {

/// Set the inertia forces of the sums. work.motion has the velocities that all other forces give over
/// `velocity_dt`, those of the implicit pressure's increments among them; the moduli of the cells and the
/// pressure's equations are set up. The increments are left as they are. Throws NumericalError.
void resist_acceleration(const Problem& problem, double dt, double velocity_dt, const State& state,
                         SemiImplicitWorkspace& work);

/// The same for a body of one phase.
void resist_acceleration(const Problem& problem, double dt, double velocity_dt, const State& state,
                         SinglePhaseWorkspace& work);

} // namespace quicksand
