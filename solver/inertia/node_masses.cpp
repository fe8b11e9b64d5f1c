#include "solver/inertia/node_masses.hpp"

#include "solver/boundaries/grid_momentum.hpp"

#include <algorithm>

namespace quicksand {

std::vector<TwoPhaseMotion> velocities_before(const Problem& problem, const NodeConditions& conditions,
                                              const WallRows& walls, const std::vector<TwoPhaseSums>& sums)
{
    std::vector<TwoPhaseMotion> before(sums.size());
    solve_two_phase_momentum(problem, conditions, 0.0, 0.0, sums, before);
    hold_at_walls(problem, sums, walls, before);
    return before;
}

std::vector<SinglePhaseMotion> velocities_before(const Problem& problem, const NodeConditions& conditions,
                                                 const WallRows& walls,
                                                 const std::vector<SinglePhaseSums>& sums)
{
    std::vector<SinglePhaseMotion> before(sums.size());
    solve_single_phase_momentum(problem, conditions, 0.0, 0.0, 0.0, sums, before);
    hold_at_walls(walls, before);
    return before;
}

NodeInverse mass_matrix(const TwoPhaseSums& node, double dt)
{
    NodeInverse mass = NodeInverse::Zero();
    const double drag = node.mass_fluid > 0.0 ? dt * node.drag : 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        mass(axis, axis) = node.mass_solid + drag;
        mass(axis, axis + 2) = mass(axis + 2, axis) = -drag;
        mass(axis + 2, axis + 2) = node.mass_fluid + drag;
    }
    return mass;
}

NodeInverse mass_matrix(const SinglePhaseSums& node, double)
{
    NodeInverse mass = NodeInverse::Zero();
    mass(0, 0) = mass(1, 1) = node.mass;
    return mass;
}

Eigen::Matrix2d half_braking(const std::vector<Dashpot>& dashpots, std::size_t node, double dt)
{
    Eigen::Matrix2d half = Eigen::Matrix2d::Zero();
    const auto found = std::lower_bound(dashpots.begin(), dashpots.end(), node,
                                        [](const Dashpot& d, std::size_t i) { return d.node < i; });
    if (found != dashpots.end() && found->node == node) half << found->xx, found->xy, found->xy, found->yy;
    return 0.5 * dt * half;
}

} // namespace quicksand
