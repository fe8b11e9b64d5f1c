#include "solver/faces/free_face.hpp"

namespace quicksand {

Vector2 full_force(const SurfaceLoad& load, const BoundaryPiece& piece, const PresentPiece& present)
{
    return piece.length * load.traction - load.pressure * present.outward();
}

Vector2 force_on(const FreeFace& face, const CarriedPiece& carried, double time)
{
    if (!face.load) return Vector2::Zero();
    return history_value(face.load->history, time) * full_force(*face.load, carried.piece, carried.present);
}

} // namespace quicksand
