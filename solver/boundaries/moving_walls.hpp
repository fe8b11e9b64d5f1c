// Walls that move: curves whose grains have a given velocity or displacement.
#pragma once

#include "solver/problem/problem.hpp"

namespace quicksand {

/// How far a segment of a moving curve has come since t = 0 [m].
Vector2 wall_displacement(const WallMotion& motion, const Segment& segment, double time);

/// Mean velocity of a segment over a step from `time` on; at its end the wall is where it has to be [m/s].
Vector2 wall_velocity(const WallMotion& motion, const Segment& segment, double time, double dt);

} // namespace quicksand
