// Gaps in the drawn soil that the grid does not see, as a sheet pile drawn as a slot.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"

namespace quicksand {

/// Warn of curves with soil beyond a gap thinner than two cells (than one whole cell between grid lines,
/// where both sides lie along the grid): the soil on both sides has nodes in common, so that it moves
/// together and water passes the gap. Of the sides of a spike only what is nearly parallel counts, over two
/// cells at least.
void check_gaps(const Scene& scene, const Problem& problem, Diagnostics& findings);

} // namespace quicksand
