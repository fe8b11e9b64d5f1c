// The motion of the nodes where inertia and pore pressure are implicit together, for long steps.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/inertia/coupled_solve.hpp"
#include "solver/problem/problem.hpp"
#include "solver/walls/wall_rows.hpp"

#include <vector>

namespace quicksand {

/// Whether waves of the skeleton pass through a good part of the soil's height within a step, from the moduli
/// of the cells and the nodes' masses: iterating from the masses is then slower than factorising.
template <class Sums>
bool is_long_step(const Problem& problem, double dt, const std::vector<Sums>& sums,
                  const InertiaSolve& inertia);

/// Set `motion` to the velocities at the end of the step, the pressure's increments, and the sums' inertia
/// forces; `acceleration` is that of the base. The pressure's equations are set up. Returns whether a
/// solution was found.
bool move_coupled(const Problem& problem, const NodeConditions& conditions, double dt, double velocity_dt,
                  double acceleration, const std::vector<Dashpot>& dashpots, const VelocityRows& rows,
                  std::vector<TwoPhaseSums>& sums, std::vector<TwoPhaseMotion>& motion, InertiaSolve& inertia,
                  PressureSolve& pressure, CoupledSolve& solve);

/// The same of a body that moves as one phase.
bool move_coupled(const Problem& problem, const NodeConditions& conditions, double dt, double velocity_dt,
                  double acceleration, const std::vector<Dashpot>& dashpots, const VelocityRows& rows,
                  std::vector<SinglePhaseSums>& sums, std::vector<SinglePhaseMotion>& motion,
                  InertiaSolve& inertia, CoupledSolve& solve);

} // namespace quicksand
