#include "solver/boundaries/moving_walls.hpp"

#include "solver/boundaries/wall_nodes.hpp"

namespace quicksand {

namespace {

/// The wall's value: its velocity or displacement at a factor of 1.
Vector2 full_motion(const WallMotion& motion, const Segment& segment)
{
    if (motion.grip == WallGrip::rough) return motion.value;
    return -motion.inward * outward_normal(segment);
}

} // namespace

Vector2 wall_displacement(const WallMotion& motion, const Segment& segment, double time)
{
    const double factor = motion.quantity == MotionQuantity::velocity
                              ? history_integral(motion.history, time)
                              : history_value(motion.history, time) - history_value(motion.history, 0.0);
    return factor * full_motion(motion, segment);
}

Vector2 wall_velocity(const WallMotion& motion, const Segment& segment, double time, double dt)
{
    return (wall_displacement(motion, segment, time + dt) - wall_displacement(motion, segment, time)) / dt;
}

} // namespace quicksand
