// A wall at which the grains stand still.
#pragma once

#include "solver/faces/face_interface.hpp"

namespace quicksand {

struct FixedWall {};

inline GrainHold hold_of(const FixedWall&, const Segment&, Stage)
{
    return GrainHold::all;
}

} // namespace quicksand
