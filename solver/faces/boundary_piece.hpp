// Pieces of boundary curves, each carried by the particle beside it (boundary_pieces.hpp).
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/particles/particles.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace quicksand {

/// A piece of a boundary curve: straight between two points that keep their places in the particle's domain.
/// Found by attach_boundaries.
struct BoundaryPiece {
    std::int32_t identifier = 0;     // lasting number of the particle [-]
    Vector2 start = Vector2::Zero(); // local coordinates in the half edges, -1..1 in a whole domain [-]
    Vector2 end = Vector2::Zero();
    double length = 0.0;    // as drawn [m]
    std::int32_t edge = -1; // of a cut domain's polygon, from the corner of this number; -1: a whole domain
};

/// A piece where it is now.
struct PresentPiece {
    Vector2 start, end;              // [m]
    std::array<Vector2, 4> corners;  // where its load reaches the grid: corners of the domain [m]
    std::array<double, 4> fractions; // of the load for the corners, adding up to 1 [-]
    double tolerance = 0.0;          // how near to a grid line a corner lies on it [cells]

    Vector2 middle() const { return 0.5 * (start + end); }
    /// Outward normal times the present length [m].
    Vector2 outward() const { return {end.y() - start.y(), start.x() - end.x()}; }
};

/// A piece with the particle that carries it.
struct CarriedPiece {
    const BoundaryPiece& piece;
    const PresentPiece& present;
    const Particles& particles;
    std::size_t p; // of the particle in the arrays
};

} // namespace quicksand
