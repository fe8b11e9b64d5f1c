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

Vector2 momentum_of_grains(const TwoPhaseSums& sums)
{
    return {sums.momentum_solid_x, sums.momentum_solid_y};
}

Vector2 momentum_of_grains(const SinglePhaseSums& sums)
{
    return {sums.momentum_x, sums.momentum_y};
}

double whole_mass(const TwoPhaseSums& sums)
{
    return sums.mass_solid + sums.mass_fluid;
}

double whole_mass(const SinglePhaseSums& sums)
{
    return sums.mass;
}

/// The nodes that have sums, after set(node, sums) has set all but their numbers. A dashpot brakes the mean
/// of the velocities before and after the step.
template <class Sums, class Set>
std::vector<CoupledNode> coupled_nodes(const NodeConditions& conditions, double velocity_dt,
                                       const std::vector<Dashpot>& dashpots, const std::vector<Sums>& sums,
                                       Set&& set)
{
    std::vector<CoupledNode> nodes;
    auto dashpot = dashpots.begin();
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!sums[i].active() || conditions.master[i] != i) continue;
        CoupledNode& node = nodes.emplace_back();
        node.node = i;
        node.held = conditions.of_node[i];
        set(node, sums[i]);
        while (dashpot != dashpots.end() && dashpot->node < i) ++dashpot;
        if (dashpot != dashpots.end() && dashpot->node == i) {
            const Eigen::Matrix2d half = half_braking(*dashpot, velocity_dt);
            node.mass.topLeftCorner<2, 2>() += half;
            node.impulse.head<2>() -= half * momentum_of_grains(sums[i]) / mass_of(sums[i]);
        }
        node.impulse -= node.mass * node.before;
    }
    return nodes;
}

// The velocities before the step are those that the balance gives without time for forces, and without the
// rows at walls: these move light nodes by far more than what the mean velocities of the particles miss them
// by, and the stiffness would answer that. So it would the momentum of water that flows past a seal, which
// the balance shares with the grains: with a displacement of beta dt times that velocity, while nothing
// moves.

/// The grains' own velocity where a seal moves them and the water together.
void leave_out_water(const TwoPhaseSums& sums, std::uint8_t held, NodeVelocities& before)
{
    const Vector2 grains = momentum_of_grains(sums) / mass_of(sums);
    if ((held & seal_x) != 0 && (held & solid_x_fixed) == 0) before[0] = grains.x();
    if ((held & seal_y) != 0 && (held & solid_y_fixed) == 0) before[1] = grains.y();
}

std::vector<CoupledNode> coupled_nodes(const Problem& problem, const NodeConditions& conditions,
                                       double velocity_dt, double acceleration,
                                       const std::vector<Dashpot>& dashpots,
                                       const std::vector<TwoPhaseSums>& sums, double kept)
{
    std::vector<TwoPhaseMotion> before(sums.size());
    solve_two_phase_momentum(problem, conditions, 0.0, 0.0, sums, before);
    return coupled_nodes(
        conditions, velocity_dt, dashpots, sums, [&](CoupledNode& node, const TwoPhaseSums& of_node) {
            node.mass = mass_matrix(of_node, velocity_dt);
            node.porosity = node_porosity(problem, of_node);
            node.before = velocities_of(before[node.node]);
            leave_out_water(of_node, node.held, node.before);
            node.before.head<2>() *= kept;
            if ((node.held & seal_x) != 0) node.before[2] = node.before[0];
            if ((node.held & seal_y) != 0) node.before[3] = node.before[1];
            const NodeImpulses given = two_phase_impulses(problem, velocity_dt, acceleration, of_node);
            node.impulse << given.solid, given.fluid;
        });
}

std::vector<CoupledNode> coupled_nodes(const Problem& problem, const NodeConditions& conditions,
                                       double velocity_dt, double acceleration,
                                       const std::vector<Dashpot>& dashpots,
                                       const std::vector<SinglePhaseSums>& sums, double kept)
{
    std::vector<SinglePhaseMotion> before(sums.size());
    solve_single_phase_momentum(problem, conditions, 0.0, 0.0, 0.0, sums, before);
    return coupled_nodes(
        conditions, velocity_dt, dashpots, sums, [&](CoupledNode& node, const SinglePhaseSums& of_node) {
            node.mass.diagonal().head<2>().setConstant(of_node.mass);
            node.before.head<2>() = kept * solid_velocity(before[node.node]);
            node.impulse.head<2>() = single_phase_impulse(problem, velocity_dt, acceleration, 0.0, of_node);
        });
}

/// Solve, call set(node, velocities) for all nodes, the motion of others being zero, and set the sums'
/// inertia forces.
template <class Sums, class Motion, class Set>
bool move_nodes(const NodeConditions& conditions, double dt, double velocity_dt,
                const std::vector<CoupledNode>& nodes, const VelocityRows& rows, std::vector<Sums>& sums,
                std::vector<Motion>& motion, InertiaSolve& inertia, PressureSolve& pressure,
                CoupledSolve& solve, Set&& set)
{
    std::vector<NodeVelocities> changes;
    if (!solve_coupled(conditions, dt, velocity_dt, inertia.resistance * dt * velocity_dt, nodes, rows,
                       inertia, pressure, solve, changes))
        return false;
    motion.assign(motion.size(), {});
    for (std::size_t k = 0; k < nodes.size(); ++k) set(nodes[k].node, nodes[k].before + changes[k]);
    multiply_stiffness(-inertia.resistance * dt, inertia.change, inertia);
    for (const CoupledNode& node : nodes) {
        const std::size_t place = inertia.places[node.node];
        sums[node.node].inertia_force_x = inertia.product.x[place];
        sums[node.node].inertia_force_y = inertia.product.y[place];
    }
    return true;
}

} // namespace

template <class Sums>
bool is_long_step(const Problem& problem, double dt, const std::vector<Sums>& sums,
                  const InertiaSolve& inertia)
{
    constexpr double part_of_height = 0.3;
    const double h = problem.grid.cell_size;
    double stiffness = 0.0, mass = 0.0;
    for (const double M : inertia.cells.constrained) stiffness += h * h * M;
    std::size_t lowest = inertia.rows.nodes_y, highest = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!sums[i].active()) continue;
        mass += whole_mass(sums[i]);
        lowest = std::min(lowest, i / inertia.rows.nodes_x);
        highest = std::max(highest, i / inertia.rows.nodes_x);
    }
    const double height = h * static_cast<double>(highest - lowest);
    return dt * std::sqrt(stiffness / mass) > part_of_height * height;
}

template bool is_long_step(const Problem&, double, const std::vector<TwoPhaseSums>&, const InertiaSolve&);
template bool is_long_step(const Problem&, double, const std::vector<SinglePhaseSums>&, const InertiaSolve&);

bool move_coupled(const Problem& problem, const NodeConditions& conditions, double dt, double velocity_dt,
                  double acceleration, const std::vector<Dashpot>& dashpots, const VelocityRows& rows,
                  std::vector<TwoPhaseSums>& sums, std::vector<TwoPhaseMotion>& motion, InertiaSolve& inertia,
                  PressureSolve& pressure, CoupledSolve& solve)
{
    set_up_stiffness([&](std::size_t i) { return sums[i].active(); }, inertia);
    const std::vector<CoupledNode> nodes =
        coupled_nodes(problem, conditions, velocity_dt, acceleration, dashpots, sums, inertia.kept);
    const auto set = [&](std::size_t i, const NodeVelocities& velocities) {
        set_velocities(problem, sums[i], velocities.head<2>(), velocities.tail<2>(), motion[i]);
    };
    if (!move_nodes(conditions, dt, velocity_dt, nodes, rows, sums, motion, inertia, pressure, solve, set))
        return false;
    spread_tied_motion(conditions, motion);
    return true;
}

bool move_coupled(const Problem& problem, const NodeConditions& conditions, double dt, double velocity_dt,
                  double acceleration, const std::vector<Dashpot>& dashpots, const VelocityRows& rows,
                  std::vector<SinglePhaseSums>& sums, std::vector<SinglePhaseMotion>& motion,
                  InertiaSolve& inertia, CoupledSolve& solve)
{
    set_up_stiffness([&](std::size_t i) { return sums[i].active(); }, inertia);
    const std::vector<CoupledNode> nodes =
        coupled_nodes(problem, conditions, velocity_dt, acceleration, dashpots, sums, inertia.kept);
    const auto set = [&](std::size_t i, const NodeVelocities& velocities) {
        set_velocity(sums[i], velocities.head<2>(), motion[i]);
    };
    PressureSolve none;
    return move_nodes(conditions, dt, velocity_dt, nodes, rows, sums, motion, inertia, none, solve, set);
}

} // namespace quicksand
