// The family of interpolations between particles and nodes, chosen per scene and compiled as separate
// kernels.
//
// A member is a type with one static function, evaluate(grid, particles, p, stencil): it fills the weights
// phi_ip and their gradients on the nodes around particle p and returns whether it had to shorten the
// particle's domain. Every member is a partition of unity and reproduces linear fields at the particle.
#pragma once

#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/background_grid.hpp"
#include "solver/particles/particles.hpp"

#include <concepts>
#include <cstddef>

namespace quicksand {

enum class Interpolation {
    linear, // the particle as a point: the material point method of Sulsky, Chen and Schreyer 1994
    gimp,   // a box of constant size: uniform GIMP, Bardenhagen and Kober 2004
    cpgimp, // a box that stretches along the axes: contiguous-particle GIMP
    cpdi,   // a parallelogram that deforms with the soil: CPDI, Sadeghirad, Brannon and Burghardt 2011
    cpdi2,  // a quadrilateral whose corners move with the grid: CPDI2, Sadeghirad, Brannon and Guilkey 2013
};

template <class Member>
concept NodeInterpolation = requires(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                                     NodeStencil& stencil)
{
    {
        Member::evaluate(grid, particles, p, stencil)
        } -> std::same_as<bool>;
};

} // namespace quicksand
