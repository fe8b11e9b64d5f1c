// The kinds of boundaries as alternatives, one row each; what a kind has to offer: face_interface.hpp.
#pragma once

#include "solver/faces/fixed_wall.hpp"
#include "solver/faces/free_face.hpp"
#include "solver/faces/free_field_side.hpp"
#include "solver/faces/moving_wall.hpp"
#include "solver/faces/roller_wall.hpp"
#include "solver/faces/tied_side.hpp"
#include "solver/faces/viscous_face.hpp"

#include <variant>

namespace quicksand {

/// The boundary condition of the grains on a curve.
using SoilCondition =
    std::variant<FreeFace, FixedWall, RollerWall, TiedSide, MovingWall, ViscousFace, FreeFieldSide>;

// The functions of face_interface.hpp for whichever kind it is. (The first has another name: a kind
// without hold_of would otherwise be converted to SoilCondition, in an endless recursion.)
GrainHold grains_held_by(const SoilCondition& soil, const Segment& segment, Stage stage);
bool lies_in_soil(const SoilCondition& soil);
bool lets_go(const SoilCondition& soil);
bool moves(const SoilCondition& soil);
Vector2 displacement_of(const SoilCondition& soil, const Segment& segment, double time);
bool presses(const SoilCondition& soil);
Vector2 force_on(const SoilCondition& soil, const CarriedPiece& carried, double time);
bool absorbs_waves(const SoilCondition& soil);
std::optional<Impedance> impedance_beyond(const SoilCondition& soil);

/// Mean velocity of a segment over a step from `time` on; at its end a moving curve is where it has to be
/// [m/s].
Vector2 velocity_of(const SoilCondition& soil, const Segment& segment, double time, double dt);

/// Let a face that lets waves out hold the grains for good.
void hold(SoilCondition& soil);

/// A wall that stands still and stays: fixed or roller.
bool is_standing_wall(const SoilCondition& soil);

/// The load on a free face; null without.
const SurfaceLoad* load_of(const SoilCondition& soil);

} // namespace quicksand
