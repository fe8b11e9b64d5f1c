// A kind of boundary condition of the grains: a plain struct of the scene's values and the functions below,
// found by its type.
//
// Every kind has
//   hold_of(kind, segment, stage)    what a segment of it holds of the grains
// and those here, which are the defaults for kinds without such a function. A new kind is a file
// (pair) with these functions, a place in SoilCondition (soil_condition.hpp) and its keys
// (io/faces/boundary_kinds.hpp).
#pragma once

#include "solver/base/stage.hpp"
#include "solver/faces/boundary_piece.hpp"
#include "solver/faces/segment.hpp"

#include <concepts>
#include <optional>

namespace quicksand {

/// What a curve holds of the grains.
enum class GrainHold { none, normal, all };

/// How long a face that lets waves out holds the grains as a wall does.
enum class FaceHold {
    while_settling,
    always, // over times in which waves do not matter: dashpots would let the soil creep away
};

/// rho V_p and rho V_s of what lies beyond a curve [Pa s/m].
struct Impedance {
    double normal = 0.0, shear = 0.0;
};

/// A kind with its own hold_of; any other argument, such as a whole boundary, does not compile.
template <class Kind>
concept SoilKind = requires(const Kind& kind, const Segment& segment, Stage stage)
{
    {
        hold_of(kind, segment, stage)
        } -> std::same_as<GrainHold>;
};

/// Whether the soil goes on beyond the curve, which then is no edge of it.
template <SoilKind Kind>
bool lies_in_soil(const Kind&)
{
    return false;
}

/// Whether the curve holds the soil only until the shaking starts. The forces that held it then go on acting
/// on its pieces.
template <SoilKind Kind>
bool lets_go(const Kind&)
{
    return false;
}

/// Whether the curve moves, and how far a segment has come since t = 0 [m].
template <SoilKind Kind>
bool moves(const Kind&)
{
    return false;
}
template <SoilKind Kind>
Vector2 displacement_of(const Kind&, const Segment&, double)
{
    return Vector2::Zero();
}

/// Whether the curve puts forces on the grains, and that on one of its pieces at a time [N/m].
template <SoilKind Kind>
bool presses(const Kind&)
{
    return false;
}
template <SoilKind Kind>
Vector2 force_on(const Kind&, const CarriedPiece&, double)
{
    return Vector2::Zero();
}

/// Whether the curve lets waves out, as into a half-space, and the impedance of that half-space; none: the
/// soil beside the curve goes on.
template <SoilKind Kind>
bool absorbs_waves(const Kind&)
{
    return false;
}
template <SoilKind Kind>
std::optional<Impedance> impedance_beyond(const Kind&)
{
    return std::nullopt;
}

} // namespace quicksand
