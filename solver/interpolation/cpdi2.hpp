// CPDI2: quadrilateral domains whose corners move with the grid (Sadeghirad, Brannon and Guilkey 2013).
//
// Corners, counter-clockwise, with half edges r_1, r_2 and twist t of the quadrilateral around its vertex
// mean c:  x_1 = c - r_1 - r_2 + t,  x_2 = c + r_1 - r_2 - t,  x_3 = c + r_1 + r_2 + t,  x_4 = c - r_1 + r_2
// - t. A parallelogram has no twist. The area is V = 4 r_1 x r_2, and the particle sits at the centroid
//   x_p = c + [(r_1 x t) r_1 + (t x r_2) r_2] / (3 r_1 x r_2).
// Weights, exact for the bilinear map of the quadrilateral:
//   phi_ip = sum_c w_c N_i(x_c),  grad phi_ip = sum_c g_c N_i(x_c)
//   w = (6V - a - b, 6V - a + b, 6V + a + b, 6V + a - b) / 24V
//   g_1 = (y2 - y4, x4 - x2) / 2V, g_2 = (y3 - y1, x1 - x3) / 2V, g_3 = -g_1, g_4 = -g_2
// with a = (x4 - x1)(y2 - y3) - (x2 - x3)(y4 - y1) and b = (x3 - x4)(y1 - y2) - (x1 - x2)(y3 - y4).
#pragma once

#include "solver/interpolation/interpolation.hpp"

#include <array>

namespace quicksand {

struct Cpdi2 {
    static bool evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                         NodeStencil& stencil);
};

/// Shrink the quadrilateral about its centroid to what may be reached from there; returns the factor [-].
double limit_corners(double cell_size, const Vector2& centre, std::array<Vector2, 4>& corners);

/// A quadrilateral as its centroid, half edges and twist [m].
struct QuadrilateralDomain {
    Vector2 centroid, half_edge_1, half_edge_2, twist;
};

/// From the corners, counter-clockwise [m].
QuadrilateralDomain quadrilateral_domain(const std::array<Vector2, 4>& corners);

/// Corners of the particle's quadrilateral, counter-clockwise [m].
std::array<Vector2, 4> quadrilateral_corners(const Particles& particles, std::size_t p);

/// The same at the reference, when displacements were last set to zero [m].
std::array<Vector2, 4> reference_corners(const Particles& particles, std::size_t p);

/// Area of the domain, which the twist does not change [m2].
double domain_area(const Particles& particles, std::size_t p);

/// Store a quadrilateral's corners as position, half edges and twist.
void set_quadrilateral(const std::array<Vector2, 4>& corners, std::size_t p, Particles& particles);

} // namespace quicksand
