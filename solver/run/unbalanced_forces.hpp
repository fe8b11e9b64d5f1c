// The out-of-balance force of a body at rest.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/walls/wall_rows.hpp"

#include <vector>

namespace quicksand {

/// sum |f_i| over the free directions of the nodes / sum of their weights, from sums with tied nodes
/// gathered and assembled wall rows; without gravity the internal forces of all nodes stand for the weights.
/// `acceleration` is that of the base, in x [m/s2].
double unbalanced_forces(const Problem& problem, double acceleration, const NodeConditions& conditions,
                         const WallRows& walls, std::vector<SinglePhaseSums> sums);

} // namespace quicksand
