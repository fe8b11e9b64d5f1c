#include "solver/inertia/coupled_motion.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/inertia/node_masses.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

NodeVelocities velocities_of(const TwoPhaseMotion& motion)
{
    return {motion.solid_x, motion.solid_y, motion.fluid_x, motion.fluid_y};
}

std::vector<CoupledNode> coupled_nodes(const Problem& problem, const NodeConditions& conditions,
                                       double velocity_dt, const std::vector<Dashpot>& dashpots,
                                       const WallRows& walls, const std::vector<TwoPhaseSums>& sums,
                                       const std::vector<TwoPhaseMotion>& motion, double kept)
{
    const std::vector<TwoPhaseMotion> before = velocities_before(problem, conditions, walls, sums);
    std::vector<CoupledNode> nodes;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!sums[i].active() || conditions.master[i] != i) continue;
        CoupledNode& node = nodes.emplace_back();
        node.node = i;
        node.mass = mass_matrix(sums[i], velocity_dt);
        node.before = velocities_of(before[i]);
        node.before.head<2>() *= kept;
        node.wanted = velocities_of(motion[i]) - node.before;
        node.held = conditions.of_node[i];
        node.porosity = node_porosity(problem, sums[i]);
    }
    for (const Dashpot& dashpot : dashpots) {
        const auto found =
            std::lower_bound(nodes.begin(), nodes.end(), dashpot.node,
                             [](const CoupledNode& node, std::size_t i) { return node.node < i; });
        if (found != nodes.end() && found->node == dashpot.node)
            found->mass.topLeftCorner<2, 2>() += half_braking(dashpot, velocity_dt);
    }
    return nodes;
}

} // namespace

bool is_long_step(const Problem& problem, double dt, const std::vector<TwoPhaseSums>& sums,
                  const InertiaSolve& inertia)
{
    constexpr double part_of_height = 0.3;
    const double h = problem.grid.cell_size;
    double stiffness = 0.0, mass = 0.0;
    for (const double M : inertia.cells.constrained) stiffness += h * h * M;
    std::size_t lowest = inertia.rows.nodes_y, highest = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const TwoPhaseSums& node = sums[i];
        if (!node.active()) continue;
        mass += node.mass_solid + node.mass_fluid;
        lowest = std::min(lowest, i / inertia.rows.nodes_x);
        highest = std::max(highest, i / inertia.rows.nodes_x);
    }
    const double height = h * static_cast<double>(highest - lowest);
    return dt * std::sqrt(stiffness / mass) > part_of_height * height;
}

bool move_coupled(const Problem& problem, const NodeConditions& conditions, double dt, double velocity_dt,
                  const std::vector<Dashpot>& dashpots, const WallRows& walls,
                  std::vector<TwoPhaseSums>& sums, std::vector<TwoPhaseMotion>& motion, InertiaSolve& inertia,
                  PressureSolve& pressure, CoupledSolve& solve)
{
    set_up_stiffness([&](std::size_t i) { return sums[i].active(); }, inertia);
    const std::vector<CoupledNode> nodes =
        coupled_nodes(problem, conditions, velocity_dt, dashpots, walls, sums, motion, inertia.kept);
    std::vector<NodeVelocities> changes;
    if (!solve_coupled(conditions, dt, velocity_dt, inertia.resistance * dt * velocity_dt, nodes, walls.rows,
                       inertia, pressure, solve, changes))
        return false;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        TwoPhaseMotion& node = motion[nodes[k].node];
        const NodeVelocities more = nodes[k].before + changes[k] - velocities_of(node);
        add_velocity(node, more.head<2>(), more.tail<2>());
        set_flux(problem, sums[nodes[k].node], node);
    }
    spread_tied_motion(conditions, motion);
    multiply_stiffness(-inertia.resistance * dt, inertia.change, inertia);
    for (const CoupledNode& node : nodes) {
        const std::size_t place = inertia.places[node.node];
        sums[node.node].inertia_force_x = inertia.product.x[place];
        sums[node.node].inertia_force_y = inertia.product.y[place];
    }
    return true;
}

} // namespace quicksand
