// The preconditioner of the pressure solve: blocks of cells, each with the factor of its own equations.
//
// In a time step pressure acts over the distance that sound in water travels, c dt = 3 to 10 cells. Blocks of
// 64 x 64 cells with a small overlap are therefore almost independent (additive Schwarz; the overlap is
// weighted to keep it symmetric). Apart from their scale the equations change slowly: one factor is used for
// many steps.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/particles/background_grid.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/walls/cell_roots.hpp"
#include "solver/walls/velocity_rows.hpp"
#include "solver/water/banded_cholesky.hpp"
#include "solver/water/block_rows.hpp"
#include "solver/water/cell_divergence.hpp"
#include "solver/water/node_touches.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// The pressure's equations: L_cc' = delta_cc' storage_c + dt^2 sum_i D_ci . W_i D_c'i.
struct PressureEquations {
    std::vector<TileDivergence> divergence; // D, per tile
    NodeCompliances compliance;             // W
    Scalars storage;                        // by slot [m2/Pa]
    Scalars diagonal;                       // of L, by slot [m2/Pa]
    std::vector<AggregatedCell> aggregated; // cells that have the pressure of their roots
    std::vector<FollowingNode> following;   // at the last set-up of the blocks
    std::vector<HeldRow> held;              // rows of walls, likewise
};

struct CellBlock {
    std::vector<std::int32_t> slots; // of the rows
    std::vector<float> scale;        // of the rows: 1 / sqrt(diagonal), and 1 / sqrt(blocks with this cell)
    BandedCholesky factor;           // of the equations scaled to a diagonal of ones
    std::vector<float> solution;     // work array of factor
    BlockRows rows;
};

struct PressureBlocks {
    std::vector<CellBlock> blocks;
    std::vector<std::uint8_t> blocks_of_slot; // how many have the cell; 0: it held no soil at the set-up
};

/// Divide the cells with soil in blocks and factorise their equations.
void set_up_blocks(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions,
                   double dt, const PressureEquations& equations, PressureBlocks& blocks);

/// Give the factors the scale of the present diagonal [m2/Pa]. A particle that has entered a cell
/// since the set-up makes all of its D larger, which the scale follows: right after a set-up that is most of
/// what changes from step to step. Before precondition(), once in a step.
void scale_blocks(const Scalars& diagonal, PressureBlocks& blocks);

/// answer = M^-1 residual, both by slot, for the cells of all blocks; the residual must be zero where there
/// is no soil any more.
void precondition(const Scalars& residual, PressureBlocks& blocks, Scalars& answer);

} // namespace quicksand
