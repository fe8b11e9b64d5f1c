// Tractions and pressures on boundary curves that move with the soil.
#pragma once

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// Add the forces of curves that press on the soil at `time` to the nodes' forces on the grains [s].
void scatter_surface_loads(const Problem& problem, double time, const Particles& particles,
                           ParticlePlaces& places, std::vector<TwoPhaseSums>& sums);
void scatter_surface_loads(const Problem& problem, double time, const Particles& particles,
                           ParticlePlaces& places, std::vector<SinglePhaseSums>& sums);

/// Add the excess pressure of the water beyond curves at `time` to the nodes' pressure forces: the grains
/// take (1 - n) of it and the water n, as of the pore pressure.
void scatter_outer_water(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, std::vector<TwoPhaseSums>& sums);

/// The same onto a body of one phase whose pores hold their pressure.
void scatter_outer_water(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, std::vector<SinglePhaseSums>& sums);

/// Whether anything on the boundary curves acts on the nodes: loads, water, held reactions.
bool has_outer_forces(const Problem& problem);

/// The same forces, and the reactions held where curves have let go, kept apart for the balances.
void note_outer_forces(const Problem& problem, double time, const State& state, ParticlePlaces& places,
                       std::vector<OuterForce>& outer);

/// The time at which a state's loads act: that of the shaking, 0 while the soil settles [s].
double load_time(const State& state);

/// The force of a boundary's load at its full value, the factor of its history being 1 [N/m].
Vector2 full_load(const Problem& problem, const State& state, const Boundary& boundary);

} // namespace quicksand
