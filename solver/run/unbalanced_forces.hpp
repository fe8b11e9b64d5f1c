// The out-of-balance force of a body at rest, and where it is largest.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/walls/wall_rows.hpp"

#include <vector>

namespace quicksand {

struct UnbalancedForces {
    double of_weight = 0.0;          // sum |f_i| / sum of the nodes' weights [-]
    Vector2 place = Vector2::Zero(); // of the node with the largest |f_i| [m]
    double share_at_place = 0.0;     // of that node in sum |f_i| [-], 0 where all forces balance
};

/// The forces f_i in the free directions of the nodes, |f| = |f_x| + |f_y|, from sums with tied nodes
/// gathered and assembled wall rows; without gravity the internal forces of all nodes stand for the weights.
/// `acceleration` is that of the base, in x [m/s2].
UnbalancedForces unbalanced_forces(const Problem& problem, double acceleration,
                                   const NodeConditions& conditions, const WallRows& walls,
                                   std::vector<SinglePhaseSums> sums);

} // namespace quicksand
