// CPDI: convected particle domain interpolation with parallelograms (Sadeghirad, Brannon and Burghardt 2011).
//
// The grid's bilinear functions N_i are replaced on a particle's domain by the bilinear interpolation of
// their values at its four corners x_1..x_4 (counter-clockwise, half edges r_1, r_2, V = 4 r_1 x r_2):
//   phi_ip  = 1/4 sum_c N_i(x_c)
//   grad phi_ip = 1/V { [N_i(x_1) - N_i(x_3)] (r_1y - r_2y, r_2x - r_1x)
//                     + [N_i(x_2) - N_i(x_4)] (r_1y + r_2y, -r_1x - r_2x) }
#pragma once

#include "solver/interpolation/interpolation.hpp"
#include "solver/particles/cell_lists.hpp"

#include <cstdint>
#include <span>

namespace quicksand {

/// A parallelogram domain: centre and half edges, r_1 x r_2 > 0 [m].
struct ParallelogramDomain {
    Vector2 centre, half_edge_1, half_edge_2;
};

struct Cpdi {
    static bool evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                         NodeStencil& stencil);
};

/// Scale down a domain that reaches farther than BackgroundGrid::domain_reach cells from its centre (Homel,
/// Brannon and Guilkey 2016 scale likewise, to one cell). Sheared neighbours overlap, so that a long domain
/// keeps its accuracy: with 2 x 2 particles a cell the limit lies at a shear strain of 9, with 3 x 3 at 14.
/// Returns whether the domain was scaled.
bool limit_domain(double cell_size, ParallelogramDomain& domain);

/// Weights of a domain whose centre lies in the grid and whose edges are limited.
void evaluate_cpdi(const BackgroundGrid& grid, const ParallelogramDomain& domain, NodeStencil& stencil);

/// Weights of all particles of a tile, in the order of the lists: what evaluate gives, to rounding. Returns
/// how many domains were scaled down.
std::int64_t weigh_parallelograms(const BackgroundGrid& grid, const Particles& particles,
                                  const CellLists& lists, const Tile& tile, StencilStore& store);

/// One corner of a domain: its part of the value and of the gradient.
struct CornerWeights {
    Vector2 position; // [m]
    double value;     // [-]
    Vector2 gradient; // [1/m]
};

/// phi = sum_c value_c N_i(x_c), grad phi = sum_c gradient_c N_i(x_c) on the stencil of all nodes concerned.
/// A corner nearer to a grid line than `tolerance` [cells] lies on it.
void sum_corner_weights(const BackgroundGrid& grid, std::span<const CornerWeights> corners,
                        NodeStencil& stencil, double tolerance);

} // namespace quicksand
