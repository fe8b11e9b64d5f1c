// An array of a frame, made ready for a quantity.
#pragma once

#include "io/frames/vtk_frame.hpp"
#include "solver/measure/quantities.hpp"

namespace quicksand {

/// Name, unit and components of the quantity's array, without values; ParaView wants a third component of
/// vectors.
FrameArray frame_array(const Quantity& quantity);

} // namespace quicksand
