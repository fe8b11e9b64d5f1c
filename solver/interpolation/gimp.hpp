// Generalised interpolation material points on axis-parallel boxes (Bardenhagen and Kober 2004):
//   phi_ip = 1/V_p int_box N_i dV,   grad phi_ip = 1/V_p int_box grad N_i dV
// both exact. In each direction, with the box [x - l/2, x + l/2] and P the primitive of the hat function N:
//   phi = (P(x + l/2) - P(x - l/2)) / l,   d phi/dx = (N(x + l/2) - N(x - l/2)) / l
#pragma once

#include "solver/interpolation/interpolation.hpp"

namespace quicksand {

/// The box keeps the size it had when displacements were last set to zero.
struct UniformGimp {
    static bool evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                         NodeStencil& stencil);
};

/// The box follows the stretch along the axes: l_a = l_a0 U_aa with the right stretch U of F = R U. (F_aa
/// instead would shrink the box when it only turns: Coombs and others 2020.)
struct ContiguousGimp {
    static bool evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                         NodeStencil& stencil);
};

/// Sizes of the boxes of the two members, limited as in their weights [m].
Vector2 uniform_box(const BackgroundGrid& grid, const Particles& particles, std::size_t p);
Vector2 contiguous_box(const BackgroundGrid& grid, const Particles& particles, std::size_t p);

} // namespace quicksand
