// Grains at walls that stand on lines of the grid.
//
// A domain's velocity is the mean over its corners and its strain the mean over a cell where the dilation is,
// so that soil that is pressed on a wall can carry a centre through it: corners beyond the wall stand still
// and the others go on. The cell beyond the wall then has a pressure and a strain of its own, along a wall
// whose nodes that centre cannot leave again. In the sea dike such single grains were thrown along the wall
// at several times the velocity of the soil beside them.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Put centres that the motion of the last dt has carried through a standing wall back on it; domains and
/// velocities stay.
void stop_at_walls(const Problem& problem, double dt, const Vectors& grid_velocity, Particles& particles);

} // namespace quicksand
