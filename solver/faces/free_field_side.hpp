// A vertical side beyond which the ground goes on level and endless (Wolf 1988; Zienkiewicz, Bicanic and Shen
// 1989). A column of its own, FreeField in solver/problem, has the motion and the stress of that ground: they
// act on the side, and dashpots take what differs from its motion (solver/boundaries/free_field.hpp). While
// the soil settles the side is a roller.
#pragma once

#include "solver/faces/face_interface.hpp"

namespace quicksand {

struct FreeFieldSide {};

inline GrainHold hold_of(const FreeFieldSide&, const Segment&, Stage stage)
{
    return stage == Stage::relaxation ? GrainHold::normal : GrainHold::none;
}

inline bool lets_go(const FreeFieldSide&)
{
    return true;
}

inline bool absorbs_waves(const FreeFieldSide&)
{
    return true;
}

} // namespace quicksand
