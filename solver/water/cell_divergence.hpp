// The divergence of nodal fluxes over the cells, and its transpose: what the pressure of the cells does to
// the nodes.
//
// D_ci = sum over the particles p of cell c of V_p grad phi_ip. The flow out of cell c is sum_i D_ci .
// flux_i, the force of the cells' pressures on node i is sum_c D_ci p_c: the same numbers both ways, so that
// pressure does as much work on the nodes as the nodes do on the pressure.
#pragma once

#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// D of one cell on a block of nodes: `height` rows of `width` nodes, width a multiple of four.
struct CellStencil {
    std::int32_t cell;  // slot of the cell lists
    std::int32_t base;  // node of the lower left corner
    std::int32_t first; // of its numbers in TileDivergence
    std::int16_t width, height;
};

/// The cells of one tile that hold soil.
struct TileDivergence {
    std::vector<CellStencil> stencils;
    std::vector<double> x, y; // D, row by row; longer than what is in use [m2/m]
    std::size_t used = 0;     // numbers of the stencils so far
};

/// Set up D for a tile from the weights of its particles.
void assemble_divergence(const BackgroundGrid& grid, const Scalars& volume, const CellLists& lists,
                         const Tile& tile, const StencilStore& store, TileDivergence& divergence);

/// flow[cell] = sum D . flux, for the cells of the tile that hold soil.
void outflows(const TileDivergence& divergence, std::int32_t nodes_x, const Scalars& flux_x,
              const Scalars& flux_y, Scalars& flow);

/// force += D^T pressure[cell].
void add_pressure_forces(const TileDivergence& divergence, std::int32_t nodes_x, const Scalars& pressure,
                         Scalars& force_x, Scalars& force_y);

} // namespace quicksand
