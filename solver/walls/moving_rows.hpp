// Values of the rows of walls that move.
//
// Where a wall that moves meets one that stands, or that moves in another way, their rows share nodes. Off
// the grid lines they then ask for velocities that no motion of the nodes has, and what meets them as well as
// it can is fast without bound. Walls that stand are therefore held first. Each one that moves is given the
// part of its motion that the walls before it leave to the nodes: u = V, made to meet their rows, and the
// values of its own rows are those of u.
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

/// Change the values of the moving chains' rows so that some motion meets all rows. `inverses` are those of
/// the rows' nodes.
void let_values_agree(const BackgroundGrid& grid, const ChainsOfRows& chains,
                      const std::vector<NodeInverse>& inverses, VelocityRows& rows);

} // namespace quicksand
