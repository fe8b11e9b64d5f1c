// Pieces of boxes that the line parts up to which water stands in the soil.
//
// Soil below the line is saturated and soil above is not: a box that belonged to one of both as a whole would
// move the water by up to half its height.
#pragma once

#include "geometry/sampling/box_cutting.hpp"
#include "solver/faces/water_condition.hpp"

#include <vector>

namespace quicksand {

/// A water line counted in boxes of a lattice. Heights nearer to a line of the lattice than rounding lie on
/// it.
class LineInBoxes {
public:
    LineInBoxes(const Lattice& lattice, const WaterLine& line);

    /// Whether the line runs through the box (i, j), and not only along its rim.
    bool crosses(int i, int j) const;

    /// Part convex pieces of the box (i, j) at the line, and above and below its knees along y. Parts smaller
    /// than `smallest_fraction` stay with their piece.
    std::vector<BoxPiece> part(int i, int j, const std::vector<BoxPiece>& pieces) const;

private:
    std::vector<Vector2> knees_; // from left to right [boxes]
};

} // namespace quicksand
