#include "solver/cell_divergence.hpp"

#include "solver/lanes.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// A square of nodes around a cell: from `before` nodes to the lower left of the cell's own corner on.
struct Block {
    int before, nodes;
};

constexpr Block narrow{1, 4}; // domains that reach at most one cell
constexpr Block wide{3, 8};   // domains at the limit, BackgroundGrid::domain_reach

/// Where a patch lies within the block: column and row of its lower left node.
struct Place {
    int column, row;
};

Place place_of(const StoredPatch& patch, const Vector2& position, const Vector2& block_corner,
               double inverse_cell_size)
{
    return {
        static_cast<int>(std::lround((patch.offset_x + position.x() - block_corner.x()) * inverse_cell_size)),
        static_cast<int>(
            std::lround((patch.offset_y + position.y() - block_corner.y()) * inverse_cell_size))};
}

/// The particles of one cell with their patches.
struct CellParticles {
    const BackgroundGrid& grid;
    const Vectors& place;
    const Scalars& volume;
    const CellLists& lists;
    const PatchStore& store;
    std::size_t first, last;  // entries of the lists
    std::size_t first_patch;  // of the entry `first`
    std::int32_t column, row; // of the cell
};

/// Add the cell's particles to its stencil; false when a patch sticks out of the block.
bool add_particles(const CellParticles& cell, Block block, double* x, double* y)
{
    const Vector2 corner = cell.grid.node_position(cell.column - block.before, cell.row - block.before);
    const double inverse = 1.0 / cell.grid.cell_size;
    for (std::size_t k = cell.first; k < cell.last; ++k) {
        const auto p = static_cast<std::size_t>(cell.lists.order[k]);
        const StoredPatch& patch = cell.store.patches[cell.first_patch + (k - cell.first)];
        const Place at = place_of(patch, cell.place[p], corner, inverse);
        const bool inside = at.column >= 0 && at.row >= 0 && at.column + patch.width <= block.nodes &&
                            at.row + patch.height <= block.nodes;
        if (!inside) return false;
        const double V = cell.volume[p];
        auto weight = static_cast<std::size_t>(patch.first);
        for (int b = 0; b < patch.height; ++b) {
            const int start = (at.row + b) * block.nodes + at.column;
            for (int a = 0; a < patch.width; ++a, ++weight) {
                x[start + a] += V * cell.store.gradient_x[weight];
                y[start + a] += V * cell.store.gradient_y[weight];
            }
        }
    }
    return true;
}

void add_stencil(const CellParticles& cell, std::int32_t slot, Block block, TileDivergence& divergence)
{
    const auto first = static_cast<std::int32_t>(divergence.x.size());
    const std::size_t count = static_cast<std::size_t>(block.nodes * block.nodes);
    divergence.x.resize(divergence.x.size() + count, 0.0);
    divergence.y.resize(divergence.y.size() + count, 0.0);
    divergence.stencils.push_back(
        {slot, (cell.row - block.before) * cell.grid.nodes_x() + cell.column - block.before, first,
         static_cast<std::int16_t>(block.nodes), static_cast<std::int16_t>(block.nodes)});
    if (add_particles(cell, block, divergence.x.data() + first, divergence.y.data() + first)) return;
    divergence.stencils.pop_back();
    divergence.x.resize(static_cast<std::size_t>(first));
    divergence.y.resize(static_cast<std::size_t>(first));
    add_stencil(cell, slot, wide, divergence);
}

} // namespace

void assemble_divergence(const BackgroundGrid& grid, const Vectors& place, const Scalars& volume,
                         const CellLists& lists, const Tile& tile, const PatchStore& store,
                         TileDivergence& divergence)
{
    divergence.stencils.clear();
    divergence.x.clear();
    divergence.y.clear();
    std::size_t patch = 0;
    for (std::int32_t slot = tile.first_cell; slot < tile.last_cell; ++slot) {
        const auto first = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(slot)]);
        const auto last = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(slot) + 1]);
        if (first == last) continue;
        const std::int32_t cell = lists.cell_of_slot[static_cast<std::size_t>(slot)];
        const CellParticles content{grid,
                                    place,
                                    volume,
                                    lists,
                                    store,
                                    first,
                                    last,
                                    patch,
                                    cell % grid.all_cells_x(),
                                    cell / grid.all_cells_x()};
        add_stencil(content, slot, narrow, divergence);
        patch += last - first;
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
