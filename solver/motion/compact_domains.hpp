// Domains of flowing soil are kept compact.
//
// Why     A domain under continued shearing becomes ten times longer than a cell and thinner than a tenth of
//         one. Its gradient is a small difference of values at distant corners, which amplifies null-space
//         modes until grains and water oscillate against each other at its nodes. A domain that is long by
//         stretching reaches through a wall: its corners before the wall then move the particle through it.
// How     Parallelograms on a lattice still tile the plane if a whole multiple of the shorter edge is
//         subtracted from the longer one: centre and area stay. A domain that is still too long has been
//         stretched: it is made shorter and wider with the same area. The reference domain is changed in the
//         same way, so that the deformation gradient stays.
// Where   Soil that yields, whose stress follows from strain increments. Elastic soil with smooth deformation
//         is more accurate with its long domains: the error of the largest vortex on 48 cells is below 1.4 %
//         with them and 3.6 % without.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// The longest half edge of a domain of soil that yields [cells]. Less than a cell, so that no particle gets
/// through a wall by more than the rim of cells around the grid.
inline constexpr double longest_half_edge = 0.75;

/// Soil that is mixed stretches without limit. The deformation gradient is recorded up to this stretch and
/// keeps its determinant beyond, which would be lost in rounding [-].
inline constexpr double largest_recorded_stretch = 1e4;

/// In every domain of a material that yields: where it is sheared by more than its own width, |r_1 . r_2| >
/// min(|r_1|^2, |r_2|^2), take the shorter half edge off the longer one, as often as it fits to the nearest;
/// where the longer is still beyond the longest half edge, scale it to that and the other by the inverse.
/// Domains that carry a piece of a boundary curve keep their edges, in which the piece has its place.
void keep_domains_compact(const Problem& problem, Particles& particles);

} // namespace quicksand
