// Domains that an outline cuts: convex polygons carried by the half edges of their particles.
//
// A corner keeps its place (alpha_c, beta_c) in the frame of the particle: x_c = x_p + alpha_c r_1 + beta_c
// r_2. The particle lies at the centroid, and V = 4 r_1 x r_2 as for whole domains, whose corners are at
// (+-1, +-1). The grid's functions N_i are integrated over the polygon as over triangles about the centroid,
// and along its edges by the trapezoid rule, corners counter-clockwise:
//   phi_ip = sum_c w_c N_i(x_c),       w_c = (A_{c-1} + A_c) / 2V
//   grad phi_ip = sum_c g_c N_i(x_c),  g_c = (y_{c+1} - y_{c-1}, x_{c-1} - x_{c+1}) / 2V
// with the area A_c of the triangle of the centroid and the corners c, c+1. Both are those of CPDI where the
// polygon is a parallelogram.
#pragma once

#include "solver/particles/particles.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

struct BackgroundGrid;
struct CellLists;
struct NodeStencil;
struct StencilStore;
struct Tile;

/// The convex polygon in the place of the domain of a particle that an outline cuts.
struct CutDomain {
    std::vector<Vector2> corners;  // (alpha, beta), counter-clockwise [-]
    std::vector<double> fractions; // w_c, adding up to 1 [-]
};

/// With the fractions w_c of the corners; their centroid is the origin.
CutDomain make_cut_domain(std::vector<Vector2> corners);

/// A piece too small for a state of its own, carried by a neighbour (slivers.hpp); lasting numbers.
struct Sliver {
    std::int32_t identifier = 0, carrier = 0;
    Vector2 centre = Vector2::Zero();                // in the carrier's half edges, from its centre [-]
    Eigen::Matrix2d edges = Eigen::Matrix2d::Zero(); // its half edges in them, by columns [-]
};

/// Which particles have a polygon. None where all domains are whole.
struct CutDomains {
    std::vector<std::int32_t> number_of; // by lasting number of the particle: index into shapes, -1: whole
    std::vector<CutDomain> shapes;
    std::vector<std::uint8_t> pieces; // by lasting number: 1 for a part of a box of the lattice, rectangles
                                      // included; soil ends within cells there

    std::vector<Sliver> slivers;

    bool has_pieces() const { return !pieces.empty(); }
    bool is_piece(std::int32_t identifier) const
    {
        const auto number = static_cast<std::size_t>(identifier);
        return number < pieces.size() && pieces[number] != 0;
    }

    /// The polygon of a particle by its lasting number; none: whole.
    const CutDomain* find(std::int32_t identifier) const
    {
        const auto number = static_cast<std::size_t>(identifier);
        if (number >= number_of.size() || number_of[number] < 0) return nullptr;
        return &shapes[static_cast<std::size_t>(number_of[number])];
    }
};

/// Corners of a polygon in a frame, counter-clockwise [m].
std::vector<Vector2> corners_in_frame(const CutDomain& shape, const Vector2& centre,
                                      const Vector2& half_edge_1, const Vector2& half_edge_2);
void corners_in_frame(const CutDomain& shape, const Vector2& centre, const Vector2& half_edge_1,
                      const Vector2& half_edge_2, std::vector<Vector2>& corners);

/// Present corners of a particle's domain, whole or cut, counter-clockwise [m].
std::vector<Vector2> domain_polygon(const CutDomains& cut_domains, const Particles& particles, std::size_t p);

/// The same at the reference, when displacements were last set to zero [m].
std::vector<Vector2> reference_polygon(const CutDomains& cut_domains, const Particles& particles,
                                       std::size_t p);

/// How near to a grid line corners of cut domains around a place lie on it: as near as the grid says, and as
/// rounding, which must not give a node mass [cells].
double line_tolerance(const BackgroundGrid& grid, const Vector2& place);

/// Scale down a polygon that reaches farther than BackgroundGrid::domain_reach from its centre, about the
/// centre; returns whether it was.
bool limit_polygon(double cell_size, const Vector2& centre, std::vector<Vector2>& corners);

/// Weights of a polygon, counter-clockwise, within the reach of its centre.
void evaluate_polygon(const BackgroundGrid& grid, const CutDomain& shape, const std::vector<Vector2>& corners,
                      NodeStencil& stencil);

/// Replace the weights of the cut domains of a tile, which are in the store as those of their parallelograms.
/// Returns how many polygons were scaled down whose parallelograms were not.
std::int64_t weigh_cut_domains(const BackgroundGrid& grid, const CutDomains& cut_domains,
                               const Particles& particles, const CellLists& lists, const Tile& tile,
                               StencilStore& store);

} // namespace quicksand
