#include "solver/run/unbalanced_forces.hpp"

#include <cmath>

namespace quicksand {

UnbalancedForces unbalanced_forces(const Problem& problem, double acceleration,
                                   const NodeConditions& conditions, const WallRows& walls,
                                   std::vector<SinglePhaseSums> sums)
{
    double weight = 0.0, internal = 0.0;
    const auto stands = [&](std::size_t i) { return sums[i].active() && conditions.master[i] == i; };
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!stands(i)) continue;
        weight += sums[i].weight * problem.gravity;
        internal += std::abs(sums[i].stress_force_x) + std::abs(sums[i].stress_force_y);
    }
    leave_unbalanced_forces(problem, acceleration, walls, sums);
    double residual = 0.0, largest = 0.0;
    UnbalancedForces forces;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!stands(i)) continue; // the master stands for its tied nodes
        const SinglePhaseSums& node = sums[i];
        const std::uint8_t held = conditions.of_node[i];
        double force = 0.0;
        if (!(held & solid_x_fixed)) force += std::abs(node.stress_force_x - node.mass * acceleration);
        if (!(held & solid_y_fixed)) force += std::abs(node.stress_force_y - node.weight * problem.gravity);
        residual += force;
        if (force <= largest) continue;
        largest = force;
        forces.place = problem.grid.node_position(i);
    }
    const double scale = weight > 0.0 ? weight : internal;
    if (scale > 0.0) forces.of_weight = residual / scale;
    if (residual > 0.0) forces.share_at_place = largest / residual;
    return forces;
}

} // namespace quicksand
