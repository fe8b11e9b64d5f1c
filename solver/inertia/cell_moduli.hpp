// The elastic moduli of the soil in the cells of the grid.
#pragma once

#include "solver/inertia/node_rows.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Sums over the particles of a cell of their parts times M, G, and M times places from the middle, x and y
/// in cells, and elongations [Pa].
struct StiffnessSums {
    double constrained = 0.0, shear = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    double elongation = 0.0; // a/b + b/a - 1 of domains with the sides a and b, 1 of squares
    double filled = 0.0;     // part of the cell [-]
};

/// Moduli of unloading times the part of the cell that soil fills, by place [Pa].
struct CellModuli {
    Scalars constrained; // M = lambda + 2 G
    Scalars shear;       // G
    std::vector<StiffnessSums> sums = {};
};

/// How many times the strain energy of particles in a cell may be that of their stiffness spread over it,
/// whatever its nodes do: at least 1 [-]. The bilinear functions have constant strains e_0, and those of
///   u_x = h_x x y,  u_y = h_y x y:  energy (M - G) (h_x y + h_y x)^2 + G (h_x^2 + h_y^2) (x^2 + y^2),
/// (M + G) (h_x^2 + h_y^2) / 12 in the mean. With c = 12 / (M + G), s the larger principal value of the
/// particles' second moments, t the sum of both, and r the distance of their mean place from the middle, the
/// energy of h is at most q = c ((M - G) s + G t) times its mean, and its product with e_0 at most
/// (c M)^(1/2) r times the root of both means. The ratio is the larger eigenvalue of
/// ((1, (c M)^(1/2) r), ((c M)^(1/2) r, q)).
double eccentricity_factor(const StiffnessSums& cell);

/// The same for domains that are longer than wide, whose gradients grow with 1 / b across their length, alone
/// in a cell: their mean elongation where a quarter of the cell is filled, 1 from three quarters on, whose
/// particles bear each other's [own]. Single domains of half edges up to .35 cells would be up to 10 times
/// stiffer than K without it. 4 beta = 1.7 are borne, and needed for moduli that grow within a step.
double elongation_factor(const StiffnessSums& cell);

/// Sum them up from the particles, as they are expected after a step of dt: grains that meet are soft before
/// and stiff after it. `resists` tells by material whose stiffness counts. A particle counts in every cell to
/// whose opposite corners it gives weight, in proportion to their products: a node then has stiffness in
/// proportion to its mass. Where the particles of a cell lie at a side of it, or are alone and long, the
/// moduli are raised such that K bounds their stiffness (eccentricity_factor(), elongation_factor()).
void sum_cell_moduli(const Problem& problem, double dt, const Particles& particles, const CellLists& lists,
                     const std::vector<StencilStore>& stencils, const std::vector<std::uint8_t>& resists,
                     const NodeRows& rows, CellModuli& cells);

} // namespace quicksand
