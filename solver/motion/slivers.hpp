// Slivers: pieces of boxes that are too small for a state of their own.
//
// Equilibrium limits the stress of a particle by the nodal forces that it causes. A sliver causes almost
// none: where soil flows, its strain is that of a single point, and its stress and volume drift (80 MPa
// beside 1 MPa in a dike). A sliver therefore keeps its place and shape in the frame of the half edges of a
// neighbour, its carrier, and takes the carrier's stress. Its mass, velocities and pore pressure are its own.
#pragma once

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// The slivers among particles as sampled: pieces of less than a tenth of a box of this volume [m3/m], each
/// with the nearest particle of its region that is no sliver. A sliver far from all others is its own
/// carrier.
std::vector<Sliver> find_slivers(const CutDomains& cut, const Particles& particles, double box_volume);

/// Move the slivers with their carriers and copy the carriers' stress and memory of the soil; the balances
/// count the momentum of the water that their pores exchange.
void carry_slivers(const Problem& problem, ParticlePlaces& places, State& state);

} // namespace quicksand
