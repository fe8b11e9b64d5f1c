// A face of the soil that nothing holds, with or without a load.
//
// The load moves and deforms with the surface that it was put on. It is the total load: where water drains
// through the curve, the grains carry all of it.
#pragma once

#include "solver/base/history.hpp"
#include "solver/faces/face_interface.hpp"

#include <optional>

namespace quicksand {

struct SurfaceLoad {
    Vector2 traction = Vector2::Zero(); // a dead load: it keeps its direction and its total, the traction on
                                        // the curve as drawn [N/m2]
    double pressure = 0.0;              // normal to the present surface and on its present length, positive
                                        // onto the soil [Pa]
    History history;

    bool operator==(const SurfaceLoad&) const = default;
};

struct FreeFace {
    std::optional<SurfaceLoad> load = {};
};

inline GrainHold hold_of(const FreeFace&, const Segment&, Stage)
{
    return GrainHold::none;
}

inline bool presses(const FreeFace& face)
{
    return face.load.has_value();
}

Vector2 force_on(const FreeFace& face, const CarriedPiece& carried, double time);

/// The force of a load on a piece, the factor of its history being 1 [N/m].
Vector2 full_force(const SurfaceLoad& load, const BoundaryPiece& piece, const PresentPiece& present);

} // namespace quicksand
