// The step of a body that moves as one phase: dry soil, undrained or drained soil, soil that settles.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/inertia/coupled_solve.hpp"
#include "solver/step/step_workspace.hpp"
#include "solver/water/pore_pressure.hpp"

#include <vector>

namespace quicksand {

struct SinglePhaseWorkspace : StepWorkspace {
    std::vector<SinglePhaseSums> sums;
    std::vector<NodalForce> outer_forces;
    std::vector<OuterForce> outer; // by nodes, for the balances; none where there are none
    std::vector<SinglePhaseMotion> motion;
    CarriedMasses masses;
    Scalars null_space_damping; // theta of null_space_damping.hpp [-]
    CellMeans cell_means;       // of the pore pressure, undrained only
    Scalars pressure_increment; // of the cells, undrained only [Pa]
    CoupledSolve coupled;       // of long implicit steps
};

SinglePhaseWorkspace make_single_phase_workspace(const Problem& problem, Stage stage = Stage::shaking);

/// Scatter the state to the nodes, tied nodes gathered: masses, momenta and forces of a step of `dt` about to
/// be taken.
void scatter_to_nodes(const Problem& problem, double dt, const State& state, SinglePhaseWorkspace& work);

/// Advance the state by one explicit step, t -> t + dt: steps 1-4, 6 and 7 of advance_two_phase_step with one
/// velocity, and step 5 in undrained shaking. Settling is drained in every scene. `damping` is the local
/// damping factor, 0 for a real motion [-]. Throws NumericalError.
void advance_single_phase_step(const Problem& problem, double dt, double damping, State& state,
                               SinglePhaseWorkspace& work);

/// As in a step of two phases; the moduli of the cells are set up.
void set_up_inertia(const Problem& problem, double dt, double velocity_dt, SinglePhaseWorkspace& work);
void resist_acceleration(double dt, double velocity_dt, SinglePhaseWorkspace& work);

} // namespace quicksand
