// Ends of seals beside drained edges. A seal is a curve inside the soil or around it that is impervious but
// not held: grains and water move together normal to it.
//
// The condition of a seal acts over the support of its nodes' functions. Where the seal ends and the soil
// drains beyond in nearly the same direction, it acts too far: by 0.8 cells at any angle and cell size, by
// 0.9 along a grid line (measured against finite elements with seals of known lengths). The condition
// therefore ends half a cell before the seal, which reduces the error to a quarter.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Distance before the end of a seal of this length at which its condition ends [m]; zero unless the soil
/// drains beyond. `segment` is the last one at this end, at its end point if `forward`, else at its start.
double drained_end(const Problem& problem, const Segment& segment, bool forward, double length, Stage stage);

} // namespace quicksand
