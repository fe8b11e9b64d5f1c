// A frame of grid.pvd: the connected grid of the cells that hold soil, with nodal averages as point data.
//
// ParaView's probe and line filters want a connected grid; the particles' own quadrilaterals share no points.
#pragma once

#include "io/frames/vtk_frame.hpp"
#include "solver/measure/nodal_fields.hpp"

namespace quicksand {

/// The cells whose four nodes all carry soil, undeformed. Point data are Float64: the same numbers as the
/// probes' at fixed points. `node_id` is the node's number in the background grid.
Frame grid_frame(const Problem& problem, const NodalFields& fields, double time);

} // namespace quicksand
