// Sorting of the particles: by cell in every step, in memory from time to time.
#pragma once

#include "solver/base/failure.hpp"
#include "solver/particles/background_grid.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Update the lists; every 64 steps also reorder the particle arrays if more than a twentieth of the
/// neighbours in a cell are not adjacent in memory. Depends on the state only: a resumed run does the same.
/// Throws NumericalError when a particle has left the grid or its position is not a number.
void sort_particles(const BackgroundGrid& grid, double dt, State& state, CellLists& lists);

/// Throws NumericalError: a corner of the particle's quadrilateral has left the grid.
[[noreturn]] void throw_lost_corner(double dt, const State& state, std::size_t p);

/// Throws NumericalError when a particle's velocity is not a number, its volume is not positive or its pores
/// have closed on their water.
void check_particles(double dt, const State& state);

/// Stage, step, time and the particle with its place; phase, what and causes are left to fill in.
FailureRecord failure_at(double dt, const State& state, std::size_t p);

/// The first whose velocity is not a number, else the fastest: where a run goes bad.
std::size_t fastest_particle(const Particles& particles);

} // namespace quicksand
