#include "solver/unbalanced_forces.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// The conditions on nodes with those of the moving walls, which stand still.
std::vector<std::uint8_t> held_directions(const NodeConditions& conditions)
{
    std::vector<std::uint8_t> held = conditions.of_node;
    for (const WallNode& wall : conditions.walls) {
        const bool rough = wall.grip == WallGrip::rough;
        for (const std::size_t node : {wall.inner, wall.outer}) {
            if (rough || wall.normal.x() != 0.0) held[node] |= solid_x_fixed;
            if (rough || wall.normal.y() != 0.0) held[node] |= solid_y_fixed;
        }
    }
    return held;
}

/// What of a force on a node a slanted wall leaves free.
Vector2 along_wall(const SlantedNode& wall, Vector2 force)
{
    if (wall.conditions & solid_y_fixed) return Vector2::Zero();
    if (wall.conditions & solid_x_fixed) force -= force.dot(wall.normal) * wall.normal;
    return force;
}

} // namespace

double unbalanced_forces(const Problem& problem, double acceleration, const NodeConditions& conditions,
                         const std::vector<SinglePhaseSums>& sums)
{
    const std::vector<std::uint8_t> held = held_directions(conditions);
    std::vector<const SlantedNode*> wall(sums.size(), nullptr);
    for (const SlantedNode& slanted : conditions.slanted) wall[slanted.node] = &slanted;
    double residual = 0.0, weight = 0.0, internal = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const SinglePhaseSums& node = sums[i];
        if (!node.active() || conditions.master[i] != i) continue; // the master stands for its tied nodes
        const double node_weight = node.weight * problem.gravity;
        Vector2 force(node.stress_force_x - node.mass * acceleration, node.stress_force_y - node_weight);
        if (wall[i] != nullptr && held[i] == 0) force = along_wall(*wall[i], force);
        if (!(held[i] & solid_x_fixed)) residual += std::abs(force.x());
        if (!(held[i] & solid_y_fixed)) residual += std::abs(force.y());
        weight += node_weight;
        internal += std::abs(node.stress_force_x) + std::abs(node.stress_force_y);
    }
    const double scale = weight > 0.0 ? weight : internal;
    return scale > 0.0 ? residual / scale : 0.0;
}

} // namespace quicksand
