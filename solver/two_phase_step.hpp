// THE step of a saturated body: explicit, water and grains with their own velocities (v-w form).
#pragma once

#include "solver/nodes.hpp"
#include "solver/pore_pressure.hpp"
#include "solver/step_workspace.hpp"

#include <vector>

namespace quicksand {

struct TwoPhaseWorkspace : StepWorkspace {
    std::vector<TwoPhaseSums> sums;
    std::vector<TwoPhaseMotion> motion;
    Scalars flux_divergence; // [1/s]
    CellMeans cell_means;    // of the pore pressure
};

TwoPhaseWorkspace make_two_phase_workspace(const Problem& problem);

/// Advance the saturated state by one explicit step, t -> t + dt.
///
///  1  particles by cell; CPDI weights from their domains
///  2  particles -> nodes: masses, momenta, forces of stress and excess pressure, drag, loads on surfaces
///  3  momentum balances of water and grains on the nodes, drag implicit at each node, with the velocity
///     conditions inside; the base's acceleration acts on both phases as a body force
///  4  nodes -> particles: velocities, velocity gradients, divergence of the flux
///  5  water: excess pore pressure, one increment per cell, and its slope within the cell
///  6  particles: position, domain, volume, porosity
///  7  grains: effective stress from the new velocity gradient (stress last)
///
/// Pre: dt <= stable_time_step(...).dt. Throws NumericalError.
void advance_two_phase_step(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work);

} // namespace quicksand
