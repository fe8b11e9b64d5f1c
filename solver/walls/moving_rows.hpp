// Values of the rows of walls that move.
//
// Where a wall that moves meets one that stands, or that moves in another way, their rows share nodes. Off
// the grid lines they then ask for velocities that no motion of the nodes has, and what meets them as well as
// it can is fast without bound, or moves nodes to and fro from one to the next, of which rows hold the mean
// alone. So each node is given the motion of the walls that it touches, in proportion to its parts in their
// rows where they ask for different velocities along one direction: the wall's motion passes over to the next
// one's within a cell, and moves as much soil as the walls do. The values of the rows are those of this
// motion.
#pragma once

#include "solver/particles/background_grid.hpp"
#include "solver/walls/velocity_rows.hpp"
#include "solver/walls/wall_contacts.hpp"

#include <vector>

namespace quicksand {

/// The rows' chains, and which of them move.
struct ChainsOfRows {
    const std::vector<bool>& moves;           // by chain
    const std::vector<std::size_t>& of_row;   // chain of each row, but for those of followers
    const std::vector<WallContact>& contacts; // with the chains' velocities
};

/// Change the values of the rows so that some motion meets all of them. `inverses` are those of
/// the rows' nodes. Returns by how much this motion differs from that of the step before, at these nodes
/// [m/s]; empty where no wall changes its velocity.
std::vector<NodeVelocities> let_values_agree(const BackgroundGrid& grid, const ChainsOfRows& chains,
                                             const std::vector<NodeInverse>& inverses, VelocityRows& rows);

} // namespace quicksand
