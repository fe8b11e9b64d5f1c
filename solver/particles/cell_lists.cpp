#include "solver/particles/cell_lists.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Column or row of a coordinate counted from the rim, -1 where the centre may not be.
int cell_index(double coordinate, double rim, double inverse_cell_size, int scene_cells)
{
    const double cells = (coordinate - rim) * inverse_cell_size;
    // one ghost cell on each side is allowed to hold centres; written so that NaN fails
    const bool allowed =
        cells >= BackgroundGrid::ghost_cells - 1 && cells < BackgroundGrid::ghost_cells + scene_cells + 1;
    return allowed ? static_cast<int>(cells) : -1;
}

/// How many particles have come to another cell, and the first that may not be where it is.
struct CellChanges {
    std::size_t changed = 0;
    FirstIndex lost; // the number of particles where none is

    CellChanges& operator+=(const CellChanges& other)
    {
        changed += other.changed;
        lost += other.lost;
        return *this;
    }
};

} // namespace

CellLists make_cell_lists(const BackgroundGrid& grid)
{
    CellLists lists;
    const int columns = grid.all_cells_x(), rows = grid.all_cells_y();
    lists.slot_of_cell.resize(grid.cell_count());
    std::int32_t slot = 0;
    for (int tile_j = 0; tile_j * CellLists::tile_cells < rows; ++tile_j) {
        for (int tile_i = 0; tile_i * CellLists::tile_cells < columns; ++tile_i) {
            const std::int32_t first = slot;
            const int j_end = std::min(rows, (tile_j + 1) * CellLists::tile_cells);
            const int i_end = std::min(columns, (tile_i + 1) * CellLists::tile_cells);
            for (int j = tile_j * CellLists::tile_cells; j < j_end; ++j) {
                for (int i = tile_i * CellLists::tile_cells; i < i_end; ++i) {
                    lists.slot_of_cell[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                                       static_cast<std::size_t>(i)] = slot++;
                }
            }
            const auto colour = static_cast<std::size_t>(2 * (tile_j % 2) + tile_i % 2);
            const Tile tile = {static_cast<std::int32_t>(lists.tiles.size()), first, slot};
            lists.tiles.push_back(tile);
            lists.tiles_of_colour[colour].push_back(tile);
        }
    }
    lists.cell_of_slot.resize(grid.cell_count());
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
        lists.cell_of_slot[static_cast<std::size_t>(lists.slot_of_cell[cell])] =
            static_cast<std::int32_t>(cell);
    }
    lists.cell_start.assign(grid.cell_count() + 1, 0);
    return lists;
}

std::int64_t update_cell_lists(const BackgroundGrid& grid, const Particles& particles, CellLists& lists)
{
    const Vector2 rim = grid.rim_origin();
    const double inverse = 1.0 / grid.cell_size;
    const int columns = grid.all_cells_x();
    const bool fresh = lists.cell_of_particle.size() != particles.size();
    if (fresh) lists.cell_of_particle.assign(particles.size(), -1);

    const CellChanges none{0, {particles.size()}};
    const auto find_cells = [&](std::size_t first, std::size_t last) {
        CellChanges found = none;
        for (std::size_t p = first; p < last; ++p) {
            const int i = cell_index(particles.position.x[p], rim.x(), inverse, grid.cells_x);
            const int j = cell_index(particles.position.y[p], rim.y(), inverse, grid.cells_y);
            if (i < 0 || j < 0) {
                found.lost += {p};
                continue;
            }
            const std::int32_t slot = lists.slot_of_cell[static_cast<std::size_t>(j * columns + i)];
            found.changed += slot != lists.cell_of_particle[p] ? 1 : 0;
            lists.cell_of_particle[p] = slot;
        }
        return found;
    };
    const CellChanges all = ordered_sum(particles.size(), none, find_cells);
    if (all.lost.index < particles.size()) return static_cast<std::int64_t>(all.lost.index);
    if (all.changed == 0 && !fresh) return -1;

    ++lists.changes;
    // stable counting sort: within a cell the particles keep their order in memory
    std::fill(lists.cell_start.begin(), lists.cell_start.end(), 0);
    for (const std::int32_t slot : lists.cell_of_particle)
        ++lists.cell_start[static_cast<std::size_t>(slot) + 1];
    for (std::size_t c = 1; c < lists.cell_start.size(); ++c) lists.cell_start[c] += lists.cell_start[c - 1];
    lists.scratch.assign(lists.cell_start.begin(), lists.cell_start.end() - 1);
    lists.order.resize(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        std::int32_t& next = lists.scratch[static_cast<std::size_t>(lists.cell_of_particle[p])];
        lists.order[static_cast<std::size_t>(next++)] = static_cast<std::int32_t>(p);
    }
    return -1;
}

double disorder(const CellLists& lists)
{
    if (lists.order.size() < 2) return 0.0;
    std::size_t jumps = 0;
    for (std::size_t k = 1; k < lists.order.size(); ++k) jumps += lists.order[k] != lists.order[k - 1] + 1;
    return static_cast<double>(jumps) / static_cast<double>(lists.order.size());
}

} // namespace quicksand
