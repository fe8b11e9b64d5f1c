// The cross product in the plane.
#pragma once

#include "solver/base/conventions.hpp"

namespace quicksand {

/// a_x b_y - a_y b_x: the area between two vectors, positive where b lies to the left of a.
inline double cross(const Vector2& a, const Vector2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace quicksand
