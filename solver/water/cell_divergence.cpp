#include "solver/water/cell_divergence.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/lanes.hpp"

#include <algorithm>
#include <cstdint>

namespace quicksand {

namespace {

/// A square of nodes around a cell: from `before` nodes to the lower left of the cell's own corner on.
struct Block {
    int before, nodes;
};

constexpr Block narrow{1, 4}; // domains that reach at most one cell
constexpr Block wide{3, 8};   // domains at the limit, BackgroundGrid::domain_reach

/// The particles of one cell with their stencils.
struct CellParticles {
    const BackgroundGrid& grid;
    const Scalars& volume;
    const CellLists& lists;
    const StencilStore& store;
    std::size_t first, last;   // entries of the lists
    std::size_t first_stencil; // of the entry `first`
    std::int32_t column, row;  // of the cell
};

/// The first `count` lanes, the others zero.
inline Lanes first_lanes(const Lanes& all, int count)
{
    using Bits = std::int64_t __attribute__((vector_size(32)));
    const Bits keep = Bits{0, 1, 2, 3} < Bits{count, count, count, count};
    return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(all) & keep);
}

/// target += factor row, for `width` numbers; zero is added to what follows up to a multiple of four.
inline void add_row(double factor, const double* row, int width, double* target)
{
    for (int a = 0; a < width; a += 4) {
        const Lanes product = factor * load_lanes(row + a);
        store_lanes(load_lanes(target + a) + first_lanes(product, width - a), target + a);
    }
}

/// Add the cell's particles to its stencil, a block and a row's end long; false when a stencil sticks out of
/// the block.
bool add_particles(const CellParticles& cell, Block block, double* x, double* y)
{
    const double *gradient_x = cell.store.gradient_x.data(), *gradient_y = cell.store.gradient_y.data();
    for (std::size_t k = cell.first; k < cell.last; ++k) {
        const auto p = static_cast<std::size_t>(cell.lists.order[k]);
        const StoredStencil& stencil = cell.store.stencils[cell.first_stencil + (k - cell.first)];
        // of the stencil, within the block
        const int column = stencil.column - (cell.column - block.before),
                  row = stencil.row - (cell.row - block.before);
        const int width = stencil.width, height = stencil.height;
        const bool inside =
            column >= 0 && row >= 0 && column + width <= block.nodes && row + height <= block.nodes;
        if (!inside) return false;
        const double V = cell.volume[p];
        int weight = stencil.first, node = row * block.nodes + column;
        for (int b = 0; b < height; ++b, weight += width, node += block.nodes) {
            add_row(V, gradient_x + weight, width, x + node);
            add_row(V, gradient_y + weight, width, y + node);
        }
    }
    return true;
}

/// Whether a row of the stencil has only zeros.
bool is_empty_row(const TileDivergence& divergence, std::int32_t first, int width)
{
    for (int a = 0; a < width; ++a) {
        const auto k = static_cast<std::size_t>(first + a);
        if (divergence.x[k] != 0.0 || divergence.y[k] != 0.0) return false;
    }
    return true;
}

/// Leave out empty rows at the bottom and at the top.
void trim(std::int32_t nodes_x, const TileDivergence& divergence, CellStencil& stencil)
{
    const int width = stencil.width;
    while (stencil.height > 1 && is_empty_row(divergence, stencil.first, width)) {
        stencil.base += nodes_x;
        stencil.first += width;
        --stencil.height;
    }
    while (stencil.height > 1 &&
           is_empty_row(divergence, stencil.first + (stencil.height - 1) * width, width))
        --stencil.height;
}

void add_stencil(const CellParticles& cell, std::int32_t slot, Block block, TileDivergence& divergence)
{
    const std::size_t first = divergence.used, count = static_cast<std::size_t>(block.nodes * block.nodes);
    const std::size_t with_row_end = count + 4;
    make_room(divergence.x, first + with_row_end);
    make_room(divergence.y, first + with_row_end);
    double *x = divergence.x.data() + first, *y = divergence.y.data() + first;
    std::fill(x, x + with_row_end, 0.0);
    std::fill(y, y + with_row_end, 0.0);
    if (!add_particles(cell, block, x, y)) {
        ENSURE(block.nodes < wide.nodes);
        add_stencil(cell, slot, wide, divergence);
        return;
    }
    divergence.used += count;
    const int nodes_x = cell.grid.nodes_x();
    divergence.stencils.push_back({slot, (cell.row - block.before) * nodes_x + cell.column - block.before,
                                   static_cast<std::int32_t>(first), static_cast<std::int16_t>(block.nodes),
                                   static_cast<std::int16_t>(block.nodes)});
    trim(nodes_x, divergence, divergence.stencils.back());
}

} // namespace

VECTOR_KERNEL
void assemble_divergence(const BackgroundGrid& grid, const Scalars& volume, const CellLists& lists,
                         const Tile& tile, const StencilStore& store, TileDivergence& divergence)
{
    divergence.stencils.clear();
    divergence.used = 0;
    std::size_t first_stencil = 0;
    for (std::int32_t slot = tile.first_cell; slot < tile.last_cell; ++slot) {
        const auto first = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(slot)]);
        const auto last = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(slot) + 1]);
        if (first == last) continue;
        const std::int32_t cell = lists.cell_of_slot[static_cast<std::size_t>(slot)];
        const CellParticles content{grid,
                                    volume,
                                    lists,
                                    store,
                                    first,
                                    last,
                                    first_stencil,
                                    cell % grid.all_cells_x(),
                                    cell / grid.all_cells_x()};
        add_stencil(content, slot, narrow, divergence);
        first_stencil += last - first;
    }
}

VECTOR_KERNEL
void outflows(const TileDivergence& divergence, std::int32_t nodes_x, const Scalars& flux_x,
              const Scalars& flux_y, Scalars& flow)
{
    for (const CellStencil& cell : divergence.stencils) {
        const double *D_x = divergence.x.data() + cell.first, *D_y = divergence.y.data() + cell.first;
        const double *row_x = flux_x.data() + cell.base, *row_y = flux_y.data() + cell.base;
        const int width = cell.width, height = cell.height;
        Lanes sum = all_lanes(0.0);
        for (int b = 0; b < height; ++b, row_x += nodes_x, row_y += nodes_x) {
            for (int a = 0; a < width; a += 4, D_x += 4, D_y += 4) {
                sum += load_lanes(D_x) * load_lanes(row_x + a) + load_lanes(D_y) * load_lanes(row_y + a);
            }
        }
        flow[static_cast<std::size_t>(cell.cell)] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    }
}

VECTOR_KERNEL
void add_pressure_forces(const TileDivergence& divergence, std::int32_t nodes_x, const Scalars& pressure,
                         Scalars& force_x, Scalars& force_y)
{
    for (const CellStencil& cell : divergence.stencils) {
        const double p = pressure[static_cast<std::size_t>(cell.cell)];
        const double *D_x = divergence.x.data() + cell.first, *D_y = divergence.y.data() + cell.first;
        double *row_x = force_x.data() + cell.base, *row_y = force_y.data() + cell.base;
        const int width = cell.width, height = cell.height;
        for (int b = 0; b < height; ++b, row_x += nodes_x, row_y += nodes_x) {
            for (int a = 0; a < width; a += 4, D_x += 4, D_y += 4) {
                store_lanes(load_lanes(row_x + a) + p * load_lanes(D_x), row_x + a);
                store_lanes(load_lanes(row_y + a) + p * load_lanes(D_y), row_y + a);
            }
        }
    }
}

} // namespace quicksand
