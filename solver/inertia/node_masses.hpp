// What a node's change of velocity is reckoned from, and the matrix of its masses.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/problem/problem.hpp"
#include "solver/walls/wall_rows.hpp"

#include <vector>

namespace quicksand {

/// Velocities at the start of the step that meet the conditions of its end; those of tied nodes are not set.
std::vector<TwoPhaseMotion> velocities_before(const Problem& problem, const NodeConditions& conditions,
                                              const WallRows& walls, const std::vector<TwoPhaseSums>& sums);
std::vector<SinglePhaseMotion> velocities_before(const Problem& problem, const NodeConditions& conditions,
                                                 const WallRows& walls,
                                                 const std::vector<SinglePhaseSums>& sums);

/// A of a node without its dashpots: masses, and the drag over dt between grains and water [kg/m].
NodeInverse mass_matrix(const TwoPhaseSums& node, double dt);

/// dt C / 2, by which a dashpot resists as a mass does [kg/m].
Eigen::Matrix2d half_braking(const Dashpot& dashpot, double dt);

} // namespace quicksand
