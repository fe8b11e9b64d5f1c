#include "solver/walls/moving_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

using Velocities = std::vector<NodeVelocities>; // by the places of the rows' nodes

/// The wall's motion at every node: that of the nearest place in contact.
Velocities motion_of(const BackgroundGrid& grid, std::size_t chain, const ChainsOfRows& chains,
                     const VelocityRows& rows)
{
    std::vector<const WallContact*> contacts;
    for (const WallContact& contact : chains.contacts)
        if (contact.chain == chain) contacts.push_back(&contact);
    Velocities motion;
    for (const std::size_t node : rows.nodes()) {
        const Vector2 place = grid.node_position(node);
        const auto nearest =
            std::min_element(contacts.begin(), contacts.end(), [&](const auto* a, const auto* b) {
                return (grid.node_position(a->node) - place).squaredNorm() <
                       (grid.node_position(b->node) - place).squaredNorm();
            });
        const Vector2& velocity = (*nearest)->velocity;
        motion.emplace_back(velocity.x(), velocity.y(), velocity.x(), velocity.y());
    }
    return motion;
}

/// Nodes that are held along an axis do not move along it.
void hold_nodes(const std::vector<NodeInverse>& inverses, Velocities& motion)
{
    for (std::size_t k = 0; k < motion.size(); ++k)
        for (int d = 0; d < 4; ++d)
            if (inverses[k](d, d) == 0.0) motion[k][d] = 0.0;
}

double largest(const Velocities& motion)
{
    double most = 0.0;
    for (const NodeVelocities& velocity : motion) most = std::max(most, velocity.cwiseAbs().maxCoeff());
    return most;
}

/// Whether the motion misses one of the chosen rows.
bool misses(const std::vector<bool>& chosen, const VelocityRows& rows, const Velocities& motion)
{
    constexpr double rounding = 1e-9; // of the motion
    const double least = rounding * largest(motion);
    for (std::size_t r = 0; r < chosen.size(); ++r)
        if (chosen[r] && std::abs(rows.product(r, motion) - rows.value(r)) > least) return true;
    return false;
}

/// The motion that meets the chosen rows, with the least change.
void meet(const std::vector<bool>& chosen, const std::vector<NodeInverse>& inverses, const VelocityRows& rows,
          Velocities& motion)
{
    VelocityRows held = rows.part(chosen);
    held.factorise(inverses);
    held.hold(motion);
}

} // namespace

void let_values_agree(const BackgroundGrid& grid, const ChainsOfRows& chains,
                      const std::vector<NodeInverse>& inverses, VelocityRows& rows)
{
    std::vector<bool> held(chains.of_row.size()); // rows whose values stand
    for (std::size_t r = 0; r < held.size(); ++r) held[r] = !chains.moves[chains.of_row[r]];
    for (std::size_t chain = 0; chain < chains.moves.size(); ++chain) {
        const auto is_of_chain = [chain](std::size_t c) { return c == chain; };
        if (!chains.moves[chain] || std::none_of(chains.of_row.begin(), chains.of_row.end(), is_of_chain))
            continue;
        Velocities free = motion_of(grid, chain, chains, rows), left = free;
        rows.extrapolate(free);
        hold_nodes(inverses, left);
        rows.extrapolate(left);
        if (misses(held, rows, left)) meet(held, inverses, rows, left);
        for (std::size_t r = 0; r < chains.of_row.size(); ++r) {
            if (chains.of_row[r] != chain) continue;
            rows.set_value(r, rows.value(r) + rows.product(r, left) - rows.product(r, free));
            held[r] = true;
        }
    }
}

} // namespace quicksand
