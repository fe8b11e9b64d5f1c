// Where impervious films end beside drained edges.
//
// A film's condition acts on all that its nodes' functions span. Where the film ends and the soil drains
// beyond in nearly the same direction, it therefore acts too far: by 0.8 cells at any angle and cell size, by
// 0.9 along a grid line, measured against finite elements with films of known lengths. Its condition ends
// half a cell before its end, which leaves a quarter of the error.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// How far before an end of a film of this length its condition ends [m]: nothing but where the soil drains
/// beyond. `segment` is that at the end, `forward` tells which of its two ends is meant.
double drained_end(const Problem& problem, const Segment& segment, bool forward, double length, Stage stage);

} // namespace quicksand
