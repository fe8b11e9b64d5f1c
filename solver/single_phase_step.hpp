// The step of a body that moves as one phase: dry soil, or saturated soil that settles drained.
#pragma once

#include "solver/boundary_conditions.hpp"
#include "solver/boundary_pieces.hpp"
#include "solver/cell_lists.hpp"
#include "solver/node_weights.hpp"
#include "solver/nodes.hpp"
#include "solver/particle_to_grid.hpp"
#include "solver/phase_timers.hpp"
#include "solver/problem.hpp"
#include "solver/state.hpp"

#include <vector>

namespace quicksand {

/// Memory of the steps; nothing of it has to survive a checkpoint.
struct SinglePhaseWorkspace {
    CellLists lists;
    NodeConditions conditions;
    std::vector<PatchStore> patches; // per tile
    std::vector<SinglePhaseSums> sums;
    std::vector<SinglePhaseMotion> motion;
    CarriedMasses masses;
    ParticlePlaces places;            // of the particles that carry boundaries
    Vectors grid_velocity;            // sum phi v_i of the grains [m/s]
    double noise_time = 0.0;          // tau of the velocity filter, see grid_to_particle.hpp [s]
    std::int64_t limited_domains = 0; // domains scaled down in the last step [-]
    PhaseTimers timers;
};

SinglePhaseWorkspace make_single_phase_workspace(const Problem& problem);

/// Scatter the state to the nodes, tied nodes gathered: masses, momenta and forces of a step of `dt` about to
/// be taken.
void scatter_to_nodes(const Problem& problem, double dt, const State& state, SinglePhaseWorkspace& work);

/// Advance the state by one explicit step, t -> t + dt: steps 1-4, 6 and 7 of advance_two_phase_step with one
/// velocity. `damping` is the local damping factor, 0 for a real motion [-]. Throws NumericalError.
void advance_single_phase_step(const Problem& problem, double dt, double damping, State& state,
                               SinglePhaseWorkspace& work);

} // namespace quicksand
