// How much of the soil lies below the level of the still water.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstddef>

namespace quicksand {

/// Part of a particle's domain below the level that static pressures count from; the scene has water [-].
/// Where water rises above the level it changes gradually as soil moves: by its centre alone a particle on
/// the level would be light below it, heavy above, and never rest. Elsewhere soil with water was below the
/// level, and is until all of it has risen.
double submerged_part(const Problem& problem, const Particles& particles, std::size_t p);

} // namespace quicksand
