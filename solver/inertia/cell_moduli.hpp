// The elastic moduli of the soil in the cells of the grid.
#pragma once

#include "solver/inertia/node_rows.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Moduli of unloading times the part of the cell that soil fills, by place [Pa].
struct CellModuli {
    Scalars constrained; // M = lambda + 2 G
    Scalars shear;       // G
};

/// Sum them up from the particles, as they are expected after a step of dt: grains that meet are soft before
/// and stiff after it. `resists` tells by material whose stiffness counts. A particle counts in every cell to
/// whose opposite corners it gives weight, in proportion to their products: a node then has stiffness in
/// proportion to its mass. A cell with a corner that no particle reaches has none.
void sum_cell_moduli(const Problem& problem, double dt, const Particles& particles, const CellLists& lists,
                     const std::vector<StencilStore>& stencils, const std::vector<std::uint8_t>& resists,
                     const NodeRows& rows, CellModuli& cells);

} // namespace quicksand
