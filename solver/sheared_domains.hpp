// Domains of flowing soil are kept compact.
//
// Why     A domain that is sheared on and on becomes a sliver, ten times as long as a cell and thinner than a
//         tenth of one. Its gradient is a small difference of values at far corners, which magnifies noise
//         until the grains and the water of its nodes swing against each other.
// How     Parallelograms on a lattice tile the plane as well when the shorter edge is taken off the longer
//         one as often as it fits: same centre and same area. With the same done to the reference domain the
//         deformation gradient stays what it was.
// Where   Soil that yields, whose stress hangs on the strain's increments. Elastic soil that follows its
//         shape smoothly is better served by its long domains: the error of the largest vortex on 48 cells
//         is 1.4 % with them and 3.6 % without.
#pragma once

#include "solver/problem.hpp"
#include "solver/state.hpp"

namespace quicksand {

/// Take the shorter half edge off the longer one, as often as it fits to the nearest, in every domain of a
/// material that yields and that is sheared by more than its own width: |r_1 . r_2| > min(|r_1|^2, |r_2|^2).
/// Domains that carry a piece of a boundary curve keep their edges, in which the piece has its place.
void shorten_sheared_domains(const Problem& problem, Particles& particles);

} // namespace quicksand
