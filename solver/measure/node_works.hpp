// Works of the forces on the nodes in a step, for the balances (balances.hpp).
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/walls/velocity_rows.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

struct NodeConditions;

/// Kinds of the nodes for the balances: 0 tied, counted at its master; 1 free; 2 held by a wall, whose
/// reaction is the change of momentum less the impulse of the known forces.
std::vector<std::uint8_t> balance_nodes(const NodeConditions& conditions);

/// Treat a node in this step as one with a reaction: the change of momentum less the impulse of the known
/// forces is the force of its dashpots, which move with the soil.
void count_reaction(std::size_t node, std::vector<std::uint8_t>& kinds);

/// The velocities with which the forces of a step work.
enum class WorkingVelocity {
    mean, // of those before and after the step
    last  // those after it
};

/// With which velocities and how long the forces of a step work, as a part of the time for which they act
/// [-].
struct Working {
    WorkingVelocity velocity = WorkingVelocity::mean;
    double share = 1.0;
};

/// Add the works of one step's forces on the nodes; returns that of the skeleton [J/m]. `dt` is the time for
/// which forces act [s], `acceleration` that of the base [m/s2]; `outer` is the part of the forces that acts
/// from outside, empty without.
double enter_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                   double acceleration, const Working& working, const std::vector<TwoPhaseSums>& sums,
                   const std::vector<OuterForce>& outer, const std::vector<TwoPhaseMotion>& motion,
                   BalanceTerms& terms);
double enter_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                   double acceleration, const Working& working, const std::vector<SinglePhaseSums>& sums,
                   const std::vector<OuterForce>& outer, const std::vector<SinglePhaseMotion>& motion,
                   BalanceTerms& terms);

/// What walls that move change in that: their reactions work with the mean of the walls' velocities before
/// and after the step. `changes` are the walls' at `rows` [m/s].
void enter_moving_walls(const Problem& problem, double dt, double acceleration, const Working& working,
                        const std::vector<TwoPhaseSums>& sums, const std::vector<TwoPhaseMotion>& motion,
                        const VelocityRows& rows, const std::vector<NodeVelocities>& changes,
                        BalanceTerms& terms);
void enter_moving_walls(const Problem& problem, double dt, double acceleration, const Working& working,
                        const std::vector<SinglePhaseSums>& sums,
                        const std::vector<SinglePhaseMotion>& motion, const VelocityRows& rows,
                        const std::vector<NodeVelocities>& changes, BalanceTerms& terms);

} // namespace quicksand
