// The drag at a node that slanted layers share.
//
// Strips along the axes of the grid, see layered_drag.hpp, are cut by a slanted face between two soils, and
// lead as the worse of them. Here the strips lie along the face. Its direction is that which tells the more
// from the less permeable soil best: with W the weights and C the moments of inertia of both about their own
// centres, and of both together, its normal n has the smallest
//   W_1 log(n.C_1 n) + W_2 log(n.C_2 n) - (W_1 + W_2) log(n.C n),
// which finds the face of two soils as well as a seam in one, where their centres coincide. The weight of a
// volume is 1 - r^2 within a cell r = 1 of the node, for phi draws the direction to the axes of the grid; phi
// tells faces along these axes, also beside a wall.
//
// Water that is held to strips meets no less resistance than water that is free. Across a seam all
// resistances add; across a face the strips leave the nodes in the open soil, whose layers end at the corners
// of their support, some freedom, without which the water of cells that the face cuts could not turn aside.
#pragma once

#include "solver/base/conventions.hpp"

#include <optional>
#include <vector>

namespace quicksand {

/// The part of a particle in the soil of a node.
struct SoilPart {
    double volume = 0.0;      // phi V [m3/m]
    double whole = 0.0;       // V [m3/m]
    double resistivity = 0.0; // rho_w g_k / k [N s/m4]
    Vector2 place;            // of its centre, from the node [cells]
    Vector2 edge_1, edge_2;   // half edges of its domain [cells]
};

/// Drags over n_i^2, see layered_drag.hpp.
struct SlantedDrag {
    double along = 0.0, across = 0.0; // [N s/m2]
    Vector2 layer;                    // unit vector along the layers [-]
};

/// By strips along the face of the soils; none where there is one soil, or the face is along the grid.
std::optional<SlantedDrag> slanted_drag(const std::vector<SoilPart>& parts);

} // namespace quicksand
