// Particles of PM4Sand: their state from and to the columns of their memory, and the update of many.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/pm4sand/pm4sand.hpp"

#include <cstddef>

namespace quicksand {

Pm4SandState state_of(std::size_t p, const Particles& particles);
void set_state(std::size_t p, const Pm4SandState& state, Particles& particles);

/// Advance the particles [first, last) by L dt; the same bits as `update` one by one.
void update(const Pm4Sand& law, double dt, std::size_t first, std::size_t last, Particles& particles);

} // namespace quicksand
