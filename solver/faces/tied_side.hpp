// One of two sides whose points of equal height move together, see TiedSides.
#pragma once

#include "solver/faces/face_interface.hpp"

namespace quicksand {

struct TiedSide {};

inline GrainHold hold_of(const TiedSide&, const Segment&, Stage)
{
    return GrainHold::none;
}

inline bool lies_in_soil(const TiedSide&)
{
    return true;
}

} // namespace quicksand
