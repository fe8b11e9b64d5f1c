// The boxes of a lattice that outlines cut, and the convex pieces of soil in them.
//
// Coordinates are counted in boxes first, and those nearer to a line of the lattice than rounding lie on it.
// From there the regions are divided in halves again and again, in exact numbers, down to the boxes that an
// outline runs through. What is left in a box is divided at its reflex corners into convex pieces.
#pragma once

#include "geometry/section/section.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace quicksand {

/// The lattice of domain-sized boxes laid over the grid's cells.
struct Lattice {
    Vector2 origin = Vector2::Zero(); // lower left corner of the first box [m]
    Vector2 size = Vector2::Zero();   // of one box [m]
    int columns = 0, rows = 0;

    Vector2 centre(int i, int j) const { return origin + size.cwiseProduct(Vector2(i + 0.5, j + 0.5)); }
    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
    }
};

/// Soil of one region in a box.
struct BoxPiece {
    std::size_t region = 0; // index into Section::regions
    Ring corners;           // convex, counter-clockwise, from the box's lower left corner [boxes]
};

/// A box that an outline runs through.
struct CutBox {
    std::size_t index = 0;                // in the lattice
    std::optional<std::size_t> filled_by; // the region that all of it belongs to
    std::vector<BoxPiece> pieces;         // where no region fills it; may be none
};

/// The least of a box that counts: smaller pieces are left out, and a box that lacks less is whole [-].
inline constexpr double smallest_fraction = 1e-6;

/// Places nearer to each other than this are the same [boxes].
inline constexpr double lattice_rounding = 1e-9;

/// A coordinate counted in boxes, on a line of the lattice where it is that near to one.
double on_lattice(double coordinate);

/// All boxes that an outline runs through, row by row from the lower left.
std::vector<CutBox> cut_boxes(const Section& section, const Lattice& lattice);

} // namespace quicksand
