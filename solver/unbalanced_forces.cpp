#include "solver/unbalanced_forces.hpp"

#include "solver/moving_walls.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// What of the force on a node the walls that stand leave free.
void take_reactions(const NodeConditions& conditions, std::vector<Vector2>& force)
{
    for (std::size_t i = 0; i < force.size(); ++i) {
        if (conditions.of_node[i] & solid_x_fixed) force[i].x() = 0.0;
        if (conditions.of_node[i] & solid_y_fixed) force[i].y() = 0.0;
    }
    for (const SlantedNode& wall : conditions.slanted) {
        Vector2& of_node = force[wall.node];
        if (wall.conditions & solid_x_fixed) of_node -= of_node.dot(wall.normal) * wall.normal;
        if (wall.conditions & solid_y_fixed) of_node.setZero();
    }
}

/// What the moving walls leave free, which stand still: the reaction that keeps a wall's pair of nodes from
/// gaining speed at the wall.
void take_reactions_of_moving_walls(const NodeConditions& conditions,
                                    const std::vector<SinglePhaseSums>& sums, std::vector<Vector2>& force)
{
    constexpr double unit_time = 1.0; // forces stand for impulses
    for_each_held_pair(conditions, unit_time, sums, [&](const WallNode& wall, const HeldPair& pair) {
        const double compliance = pair.at_wall().solid;
        if (compliance <= 0.0) return;
        const double outer = pair.outer_share, inner = 1.0 - outer;
        const double gained = inner * pair.inner.solid * force[wall.inner].dot(pair.direction) +
                              outer * pair.outer.solid * force[wall.outer].dot(pair.direction);
        force[wall.inner] -= inner * gained / compliance * pair.direction;
        force[wall.outer] -= outer * gained / compliance * pair.direction;
    });
}

} // namespace

double unbalanced_forces(const Problem& problem, double acceleration, const NodeConditions& conditions,
                         const std::vector<SinglePhaseSums>& sums)
{
    std::vector<Vector2> force(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const SinglePhaseSums& node = sums[i];
        force[i] = Vector2(node.stress_force_x - node.mass * acceleration,
                           node.stress_force_y - node.weight * problem.gravity);
    }
    take_reactions(conditions, force);
    take_reactions_of_moving_walls(conditions, sums, force);
    double residual = 0.0, weight = 0.0, internal = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const SinglePhaseSums& node = sums[i];
        if (!node.active() || conditions.master[i] != i) continue; // the master stands for its tied nodes
        residual += force[i].lpNorm<1>();
        weight += node.weight * problem.gravity;
        internal += std::abs(node.stress_force_x) + std::abs(node.stress_force_y);
    }
    const double scale = weight > 0.0 ? weight : internal;
    return scale > 0.0 ? residual / scale : 0.0;
}

} // namespace quicksand
