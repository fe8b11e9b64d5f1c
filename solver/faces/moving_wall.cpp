#include "solver/faces/moving_wall.hpp"

namespace quicksand {

namespace {

/// The wall's value: its velocity or displacement at a factor of 1.
Vector2 full_motion(const WallMotion& motion, const Segment& segment)
{
    if (motion.grip == WallGrip::rough) return motion.value;
    return -motion.inward * outward_normal(segment);
}

} // namespace

GrainHold hold_of(const MovingWall& wall, const Segment&, Stage)
{
    return wall.motion.grip == WallGrip::rough ? GrainHold::all : GrainHold::normal;
}

Vector2 displacement_of(const MovingWall& wall, const Segment& segment, double time)
{
    const WallMotion& motion = wall.motion;
    const double factor = motion.quantity == MotionQuantity::velocity
                              ? history_integral(motion.history, time)
                              : history_value(motion.history, time) - history_value(motion.history, 0.0);
    return factor * full_motion(motion, segment);
}

} // namespace quicksand
