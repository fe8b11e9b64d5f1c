#include "solver/inertia/coupled_motion.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/inertia/node_masses.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

NodeVelocities velocities_of(const TwoPhaseMotion& motion)
{
    return {motion.solid_x, motion.solid_y, motion.fluid_x, motion.fluid_y};
}

/// Add a dashpot, which brakes the mean of the velocities before and after the step, to the node's equations.
void add_dashpot(const Dashpot& dashpot, double velocity_dt, const TwoPhaseSums& sums, CoupledNode& node)
{
    const Eigen::Matrix2d half = half_braking(dashpot, velocity_dt);
    node.mass.topLeftCorner<2, 2>() += half;
    node.impulse.head<2>() -= half * Vector2(sums.momentum_solid_x, sums.momentum_solid_y) / sums.mass_solid;
}

std::vector<CoupledNode> coupled_nodes(const Problem& problem, const NodeConditions& conditions,
                                       double velocity_dt, double acceleration,
                                       const std::vector<Dashpot>& dashpots,
                                       const std::vector<TwoPhaseSums>& sums, double kept)
{
    // Without the rows at walls: those move light nodes by far more than what the mean velocities of the
    // particles miss them by, and the stiffness would answer that.
    std::vector<TwoPhaseMotion> before(sums.size());
    solve_two_phase_momentum(problem, conditions, 0.0, 0.0, sums, before);
    std::vector<CoupledNode> nodes;
    auto dashpot = dashpots.begin();
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!sums[i].active() || conditions.master[i] != i) continue;
        CoupledNode& node = nodes.emplace_back();
        node.node = i;
        node.mass = mass_matrix(sums[i], velocity_dt);
        node.before = velocities_of(before[i]);
        node.before.head<2>() *= kept;
        node.held = conditions.of_node[i];
        if ((node.held & seal_x) != 0) node.before[2] = node.before[0];
        if ((node.held & seal_y) != 0) node.before[3] = node.before[1];
        node.porosity = node_porosity(problem, sums[i]);
        const NodeImpulses given = two_phase_impulses(problem, velocity_dt, acceleration, sums[i]);
        node.impulse << given.solid, given.fluid;
        while (dashpot != dashpots.end() && dashpot->node < i) ++dashpot;
        if (dashpot != dashpots.end() && dashpot->node == i)
            add_dashpot(*dashpot, velocity_dt, sums[i], node);
        node.impulse -= node.mass * node.before;
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
                  double acceleration, const std::vector<Dashpot>& dashpots, const VelocityRows& rows,
                  std::vector<TwoPhaseSums>& sums, std::vector<TwoPhaseMotion>& motion, InertiaSolve& inertia,
                  PressureSolve& pressure, CoupledSolve& solve)
{
    set_up_stiffness([&](std::size_t i) { return sums[i].active(); }, inertia);
    const std::vector<CoupledNode> nodes =
        coupled_nodes(problem, conditions, velocity_dt, acceleration, dashpots, sums, inertia.kept);
    std::vector<NodeVelocities> changes;
    if (!solve_coupled(conditions, dt, velocity_dt, inertia.resistance * dt * velocity_dt, nodes, rows,
                       inertia, pressure, solve, changes))
        return false;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t i = nodes[k].node;
        const NodeVelocities velocities = nodes[k].before + changes[k];
        set_velocities(problem, sums[i], velocities.head<2>(), velocities.tail<2>(), motion[i]);
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
