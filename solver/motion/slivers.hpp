// Slivers: pieces of boxes that are too small for a state of their own.
//
// The stress of a particle is kept in check by the forces that it makes. That of a sliver makes next to none:
// where soil flows, its strain is that of a point, and its stress and volume drift away (80 MPa beside 1 MPa
// in a dike). A neighbour therefore carries it: the sliver keeps its place and shape in the frame of the
// neighbour's half edges, and has the neighbour's stress. Its mass, velocities and pore pressure are its own.
#pragma once

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// The slivers among particles as sampled: pieces of less than a tenth of a box of this volume [m3/m], each
/// with the nearest particle of its region that is none. A sliver far from all others carries itself.
std::vector<Sliver> find_slivers(const CutDomains& cut, const Particles& particles, double box_volume);

/// Bring the slivers to where their carriers have them, with their stress and what the soil remembers; the
/// balances get the momentum that their pores exchange for it.
void carry_slivers(const Problem& problem, ParticlePlaces& places, State& state);

} // namespace quicksand
