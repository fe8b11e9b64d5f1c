// Faults of outlines against themselves and each other, found with CGAL's exact Boolean operations.
//
// Coordinates are rounded to a lattice of 1e-9 of the section's size first, and slivers a few lattice steps
// thin are no faults: neighbours that gmsh rounded differently still fit.
#pragma once

#include "geometry/section/section.hpp"

#include <cstddef>
#include <vector>

namespace quicksand {

struct OutlineFault {
    enum class Kind {
        too_few_vertices,  // `region` has a ring of less than three different vertices
        self_intersection, // `region`'s ring crosses or touches itself
        wrong_hole,        // a hole of `region` leaves its outer ring or meets another hole
        overlap,           // `region` and `other` share soil
        gap,               // between `region` and `other` is an enclosed void
    };
    Kind kind = Kind::too_few_vertices;
    std::size_t region = 0, other = 0; // indices into Section::regions
    Vector2 lower = Vector2::Zero();   // box around the fault; for a crossing both are its point [m]
    Vector2 upper = Vector2::Zero();
    double area = 0.0; // of an overlap or gap [m2]
};

/// All faults; a region whose own rings are at fault is left out of the comparisons.
std::vector<OutlineFault> find_outline_faults(const Section& section);

} // namespace quicksand
