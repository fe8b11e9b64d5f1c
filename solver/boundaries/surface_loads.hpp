// Tractions and pressures on boundary curves that move with the soil.
#pragma once

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// Add the forces of curves that press on the soil at `time` [s].
void add_surface_loads(const Problem& problem, double time, const Particles& particles,
                       ParticlePlaces& places, std::vector<NodalForce>& forces);

/// Add those of the excess pressure of the water beyond curves at `time` [s].
void add_outer_water(const Problem& problem, double time, const Particles& particles, ParticlePlaces& places,
                     std::vector<NodalForce>& forces);

/// The time at which a state's loads act: that of the shaking, 0 while the soil settles [s].
double load_time(const State& state);

/// The force of a boundary's load at its full value, the factor of its history being 1 [N/m].
Vector2 full_load(const Problem& problem, const State& state, const Boundary& boundary);

} // namespace quicksand
