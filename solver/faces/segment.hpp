// Straight pieces of boundary curves.
#pragma once

#include "solver/base/conventions.hpp"

#include <Eigen/Core>

namespace quicksand {

/// A straight piece of a boundary curve; the soil lies to its left, going from start to end.
struct Segment {
    Vector2 start, end;  // [m]
    bool is_dry = false; // the soil beside it has no water; found by attach_boundaries
};

/// The normal of a segment out of the soil [-].
inline Vector2 outward_normal(const Segment& segment)
{
    const Vector2 along = (segment.end - segment.start).normalized();
    return {along.y(), -along.x()};
}

} // namespace quicksand
