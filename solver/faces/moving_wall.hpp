// A wall with a given velocity or displacement.
#pragma once

#include "solver/base/history.hpp"
#include "solver/faces/face_interface.hpp"

namespace quicksand {

enum class MotionQuantity { velocity, displacement };
enum class WallGrip {
    rough,  // the grains take part in the wall's motion in both directions
    smooth, // in that normal to the wall only
};

/// The motion of a moving boundary curve.
struct WallMotion {
    MotionQuantity quantity = MotionQuantity::velocity;
    WallGrip grip = WallGrip::rough;
    Vector2 value = Vector2::Zero(); // of a rough wall [m/s] or [m]
    double inward = 0.0;             // of a smooth wall, normal to it and positive into the soil [m/s] or [m]
    History history;

    bool operator==(const WallMotion&) const = default;
};

struct MovingWall {
    WallMotion motion;
};

GrainHold hold_of(const MovingWall& wall, const Segment& segment, Stage stage);

inline bool moves(const MovingWall&)
{
    return true;
}

Vector2 displacement_of(const MovingWall& wall, const Segment& segment, double time);

} // namespace quicksand
