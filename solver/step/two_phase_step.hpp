// THE step of a saturated body: water and grains with their own velocities (v-w form), explicit or with the
// water's pressure implicit.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/drag/layered_drag.hpp"
#include "solver/inertia/coupled_solve.hpp"
#include "solver/step/step_workspace.hpp"
#include "solver/water/pore_pressure.hpp"
#include "solver/water/pressure_solve.hpp"

#include <vector>

namespace quicksand {

struct TwoPhaseWorkspace : StepWorkspace {
    Scalars wet_volume; // of the wet particles, 0 of the others [m3/m]
    std::vector<TwoPhaseSums> sums;
    std::vector<NodalForce> outer_forces;
    std::vector<OuterForce> outer; // by nodes, for the balances; none where there are none
    std::vector<TwoPhaseMotion> motion;
    Scalars flux_divergence;    // [1/s]
    Scalars pressure_increment; // of the cells [Pa]
    CellMeans cell_means;       // of the pore pressure
    LayeredDrag layered_drag;   // of soils of unlike conductivity
};

/// What the semi-implicit step needs besides.
struct SemiImplicitWorkspace : TwoPhaseWorkspace {
    PressureSolve pressure;
    PressureSolveControls controls;
    CoupledSolve coupled; // of long steps
};

TwoPhaseWorkspace make_two_phase_workspace(const Problem& problem);

/// Scatter the state to the nodes, tied nodes gathered: masses, momenta and forces of a step of `dt` about to
/// be taken; `time` is that of the loads [s].
void scatter_to_nodes(const Problem& problem, double dt, double time, const State& state,
                      TwoPhaseWorkspace& work);

/// Advance the saturated state by one explicit step, t -> t + dt.
///
///  1  particles by cell; CPDI weights from their domains
///  2  particles -> nodes: masses, momenta, forces of stress and excess pressure, drag, loads on surfaces
///  3  momentum balances of water and grains on the nodes, drag at the time of the forces, implicit where
///     it is strong (centre_drag), with the velocity conditions inside; the base's acceleration acts on
///     both phases as a body force
///  4  nodes -> particles: velocities, velocity gradients, divergence of the flux
///  5  water: excess pore pressure, one increment per cell, and its slope within the cell
///  6  particles: position, domain, volume, porosity
///  7  grains: effective stress from the new velocity gradient (stress last)
///
/// Pre: dt <= stable_time_step(...).dt. Throws NumericalError.
void advance_two_phase_step(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work);

SemiImplicitWorkspace make_semi_implicit_workspace(const Problem& problem);

/// The same step with the water's pressure implicit: between 3 and 4 the increments of the cells' pressure
/// are solved for with drag and walls inside (pressure_solve.hpp), and the momentum balances again with their
/// force; 5 takes these increments. Waves of the water no longer limit dt.
///
/// With work.inertia the skeleton's stiffness resists accelerations: after the pressure, which answers it
/// (skeleton_inertia.cpp), or in long steps together with it (coupled_solve.hpp). Waves of the skeleton do
/// not limit dt either.
///
/// Pre: dt <= stable_time_step(...).dt. Throws NumericalError.
void advance_semi_implicit_step(const Problem& problem, double dt, State& state, SemiImplicitWorkspace& work);

/// Divergence and storage of the cells, and compliances of the nodes with their boundaries
/// (implicit_pressure.cpp).
void set_up_pressure(const Problem& problem, double dt, double velocity_dt, const Particles& particles,
                     SemiImplicitWorkspace& work);

/// The same, and the preconditioner of their solution. Of a step's motion it reads nothing.
void prepare_pressure(const Problem& problem, double dt, double velocity_dt, const Particles& particles,
                      SemiImplicitWorkspace& work);

/// Add the forces of the pressure's increments to those on the nodes.
void add_increment_forces(const Problem& problem, SemiImplicitWorkspace& work);

/// Solve the equations of prepare_pressure() with the fluxes in work.motion, and add the forces of the
/// increments to those on the nodes; the flux changes over `velocity_dt` and fills cells over `dt`. Throws
/// NumericalError.
void find_increments(const Problem& problem, double dt, double velocity_dt, const State& state,
                     SemiImplicitWorkspace& work);

/// Factorise the response of nodes whose stiffness resists accelerations, from the moduli of the cells and
/// the sums, tied nodes gathered (skeleton_inertia.cpp).
void set_up_inertia(const Problem& problem, double dt, double velocity_dt, SemiImplicitWorkspace& work);

/// Set the inertia forces of work.sums to those of the velocities that the sums' other forces give with them.
/// work.motion has the velocities that the sums, with the former inertia forces, give over `velocity_dt`.
void resist_acceleration(double dt, double velocity_dt, SemiImplicitWorkspace& work);
/// The largest velocity that would follow from what these forces miss of those of the change of velocity in
/// work.motion, over the largest change [-]; light nodes, which have their forces from the balance of
/// momentum, excepted.
double missing_inertia(double dt, SemiImplicitWorkspace& work);

} // namespace quicksand
