// Particles of PM4Sand: their state from and to the columns of their memory, and the update of many.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/pm4sand/pm4sand.hpp"

#include <cstddef>

namespace quicksand {

Pm4SandState state_of(std::size_t p, const Particles& particles);
void set_state(std::size_t p, const Pm4SandState& state, Particles& particles);

inline constexpr std::size_t numbers_of_cycles = 24; // of the memory, before those of a history [-]

/// Advance the particles [first, last) by L dt, of whose gradients L_xx and L_yy begin with the first
/// particle; the same bits as `update` one by one.
void update(const Pm4Sand& law, double dt, std::size_t first, std::size_t last, const double* L_xx,
            const double* L_yy, Particles& particles);

} // namespace quicksand
