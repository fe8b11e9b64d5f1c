// The force with which the skeleton's stiffness resists accelerations: - beta dt K (v' - v).
//
// It is what makes the nodal mass M + beta dt dt_v K: for the grains
//   (M + beta dt dt_v K) (v' - v) = dt_v f,   dt_v the time over which forces act
// The step is then the operator-splitting method (Nakashima 1990) in leapfrog form: with K_t, the stiffness
// by which the present stress changes, it is stable at any dt where K_t <= 4 beta K. beta = 1/2 bears a mean
// stress that grows fourfold within a step, for the moduli of sand grow with its root. The period of a motion
// of the frequency omega is (beta - 1/12) (omega dt)^2 / 2 too long, and nothing is damped. Rest, steady flow
// and constant velocities are exact; translations and small turns meet no force, so that momentum is.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/inertia/inertia_solve.hpp"
#include "solver/problem/problem.hpp"
#include "solver/walls/wall_rows.hpp"

#include <vector>

namespace quicksand {

inline constexpr double inertia_fraction = 0.5; // beta [-]

/// Set the sums' inertia forces. `motion` are the velocities that all other forces give over `velocity_dt`,
/// with the conditions at walls; the moduli of the cells are those of the solve. Returns whether they were
/// found.
bool resist_acceleration(const Problem& problem, const NodeConditions& conditions, double dt,
                         double velocity_dt, const std::vector<Dashpot>& dashpots, const WallRows& walls,
                         const std::vector<TwoPhaseMotion>& motion, std::vector<TwoPhaseSums>& sums,
                         InertiaSolve& solve);
bool resist_acceleration(const Problem& problem, const NodeConditions& conditions, double dt,
                         double velocity_dt, const std::vector<Dashpot>& dashpots, const WallRows& walls,
                         const std::vector<SinglePhaseMotion>& motion, std::vector<SinglePhaseSums>& sums,
                         InertiaSolve& solve);

} // namespace quicksand
