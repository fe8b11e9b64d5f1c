// The cells of a body, one after the other.
#pragma once

#include "solver/particles/cell_lists.hpp"

#include <cstddef>
#include <cstdint>

namespace quicksand {

/// Call work(slot) for all cells that may hold soil, on all threads; work may change what is in its cell.
template <class Work>
void for_each_slot(const CellLists& lists, Work&& work)
{
    for_each_tile(lists, [&](const Tile& tile) {
        for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) work(static_cast<std::size_t>(c));
    });
}

} // namespace quicksand
