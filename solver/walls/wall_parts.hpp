// How the discrete boundary normal of a node is divided among the curves that meet there.
#pragma once

#include "solver/walls/wall_contacts.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// The part of a node's normal that belongs to a chain: a_i = sum of length times direction over the curves
/// at i.
struct WallPart {
    const WallContact* contact = nullptr;
    double length = 0.0;                 // g_i, never negative [m]
    Vector2 direction = Vector2::Zero(); // outward [-]
};

/// The parts of all chains at nodes that are `active`, in the order of the nodes. `normal` are the a_i [m].
///
/// Where one wall touches a node it has all of a_i along its own normal; a bent wall takes the direction of
/// a_i, which is the mean of its own. Where several curves touch, g_k starts from the length under the node's
/// function and is corrected by the least change in proportion to it that makes up a_i. A wall beyond its end
/// has a part where soil has come to it.
std::vector<WallPart> divide_normals(double cell_size, const SoilEdges& edges, const WallContacts& contacts,
                                     const std::vector<std::uint8_t>& active, const Vectors& normal);

} // namespace quicksand
