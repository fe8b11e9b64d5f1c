// A vertical side beyond which the ground goes on level and endless (Wolf 1988; Zienkiewicz, Bicanic and Shen
// 1989). A column of its own, FreeField in solver/problem, has the motion and the stress of that ground: they
// act on the side, and dashpots take what differs from its motion (solver/boundaries/free_field.hpp). While
// the soil settles, and over long times, the side is a roller, with the water of the column beyond it.
#pragma once

#include "solver/faces/face_interface.hpp"

namespace quicksand {

struct FreeFieldSide {
    FaceHold held = FaceHold::while_settling;
};

inline bool lets_go(const FreeFieldSide& side)
{
    return side.held != FaceHold::always;
}

inline GrainHold hold_of(const FreeFieldSide& side, const Segment&, Stage stage)
{
    return stage == Stage::relaxation || !lets_go(side) ? GrainHold::normal : GrainHold::none;
}

inline bool absorbs_waves(const FreeFieldSide& side)
{
    return side.held != FaceHold::always;
}

/// The ground beyond, and its water.
inline bool presses(const FreeFieldSide&)
{
    return true;
}

} // namespace quicksand
