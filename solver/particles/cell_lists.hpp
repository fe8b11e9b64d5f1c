// Which particles lie in which cell, and the tiles of cells that threads work on.
//
// Cells are grouped in square tiles of 8 x 8. A particle of a tile reaches nodes at most three cells outside
// it, so tiles of the same colour (even or odd tile row, even or odd tile column) never share a node and are
// scattered at the same time; the four colours follow each other. Each tile is worked through by one thread
// in a fixed order: sums are the same bits for any number of threads.
#pragma once

#include "solver/base/threads.hpp"
#include "solver/particles/background_grid.hpp"
#include "solver/particles/particles.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace quicksand {

/// A square of cells; its particles follow each other in CellLists::order.
struct Tile {
    std::int32_t number = 0;     // counts the tiles of the grid [-]
    std::int32_t first_cell = 0; // slots [first_cell, last_cell) of CellLists::cell_start
    std::int32_t last_cell = 0;
};

struct CellLists {
    static constexpr int tile_cells = 8;

    std::vector<std::int32_t> slot_of_cell;     // grid cell -> place in the tile-by-tile order of cells [-]
    std::vector<std::int32_t> cell_of_slot;     // and back [-]
    std::vector<std::int32_t> cell_of_particle; // slot of the cell of the particle's centre [-]
    std::vector<std::int32_t> cell_start;       // slot -> first entry of `order`; one more than slots [-]
    std::vector<std::int32_t> order;            // particles, cell by cell [-]
    std::vector<std::uint8_t> takes_others;     // by slot: has particles of other cells; none: no slot does
    std::vector<std::uint8_t> takes_table; // by slot: of cells that the water table parts; none: no slot does
    std::vector<Tile> tiles;               // by number
    std::array<std::vector<Tile>, 4> tiles_of_colour;
    std::vector<std::int32_t> scratch; // buffer of the counting sort
    std::int64_t changes = 0;          // how often `order` has been set up anew [-]

    /// Entries of `order` that belong to a tile: [first_entry, last_entry).
    std::size_t first_entry(const Tile& tile) const
    {
        return static_cast<std::size_t>(cell_start[static_cast<std::size_t>(tile.first_cell)]);
    }
    std::size_t last_entry(const Tile& tile) const
    {
        return static_cast<std::size_t>(cell_start[static_cast<std::size_t>(tile.last_cell)]);
    }

    /// Whether badly filled cells are aggregated with that of a slot.
    bool is_root(std::size_t slot) const { return !takes_others.empty() && takes_others[slot] != 0; }

    /// Whether one of them holds little water because the rest of its soil is dry.
    bool is_below_table(std::size_t slot) const { return !takes_table.empty() && takes_table[slot] != 0; }
};

/// Lists for a grid, still without particles.
CellLists make_cell_lists(const BackgroundGrid& grid);

/// Bring the lists up to date with the positions. Returns the index of a particle whose centre lies more than
/// a cell outside the scene's grid or is not a number, or -1.
std::int64_t update_cell_lists(const BackgroundGrid& grid, const Particles& particles, CellLists& lists);

/// Fraction of particles whose neighbour in memory is not their neighbour in the lists [-].
double disorder(const CellLists& lists);

/// Queues of tiles with equal numbers of particles, the same particles for a thread as in loops over
/// particles.
inline WorkQueues queues_of(const CellLists& lists, const std::vector<Tile>& tiles, int threads)
{
    return WorkQueues(threads, [&](int k, int queues) {
        const std::size_t first =
            lists.order.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(queues);
        const auto starts_before = [&](const Tile& tile) { return lists.first_entry(tile) < first; };
        const auto begin = std::partition_point(tiles.begin(), tiles.end(), starts_before);
        return static_cast<std::uint32_t>(k == queues ? tiles.size() : begin - tiles.begin());
    });
}

/// Call work(tile) for every tile, tiles of one colour at the same time, one colour after another.
template <class Work>
void for_each_tile_by_colour(const CellLists& lists, Work&& work)
{
    const int threads = threads_for(lists.order.size());
    if (threads == 1) {
        for (const std::vector<Tile>& tiles : lists.tiles_of_colour)
            for (const Tile& tile : tiles) work(tile);
        return;
    }
    const auto queues_of_colour = [&](std::size_t colour) {
        return queues_of(lists, lists.tiles_of_colour[colour], threads);
    };
    std::array<WorkQueues, 4> queues = {queues_of_colour(0), queues_of_colour(1), queues_of_colour(2),
                                        queues_of_colour(3)};
#pragma omp parallel num_threads(threads)
    for (std::size_t colour = 0; colour < 4; ++colour) {
        const std::vector<Tile>& tiles = lists.tiles_of_colour[colour];
        while (const auto t = queues[colour].take(thread_number())) work(tiles[*t]);
#pragma omp barrier
    }
}

/// Call work(tile) for every tile, all at the same time: for work that writes only to the tile's particles.
template <class Work>
void for_each_tile(const CellLists& lists, Work&& work)
{
    const int threads = threads_for(lists.order.size());
    if (threads == 1) {
        for (const Tile& tile : lists.tiles) work(tile);
        return;
    }
    WorkQueues queues = queues_of(lists, lists.tiles, threads);
    on_threads(threads, [&] {
        while (const auto t = queues.take(thread_number())) work(lists.tiles[*t]);
    });
}

} // namespace quicksand
