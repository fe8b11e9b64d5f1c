// A wall along which the grains slide.
#pragma once

#include "solver/faces/face_interface.hpp"

namespace quicksand {

struct RollerWall {};

inline GrainHold hold_of(const RollerWall&, const Segment&, Stage)
{
    return GrainHold::normal;
}

} // namespace quicksand
