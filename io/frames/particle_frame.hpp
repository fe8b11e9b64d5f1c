// A frame of fields.pvd: every particle a quadrilateral cell with its own four corners and its state.
#pragma once

#include "io/frames/vtk_frame.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Cell data are Float32, which keeps seven digits; fluid fields are left out of a dry scene.
Frame particle_frame(const Problem& problem, const State& state);

} // namespace quicksand
