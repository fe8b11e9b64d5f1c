#include "solver/water/pressure_blocks.hpp"

#include "solver/base/threads.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace quicksand {

namespace {

constexpr int largest_block = 64;        // cells along a side, without the overlap
constexpr int overlap = 6;               // cells of its neighbours that a block takes in
constexpr std::size_t largest_band = 88; // a row of such a block and twelve cells; the rest is left out
constexpr float least_pivot = 1e-4f;     // of a diagonal of ones

/// The smallest rectangle of cells around those with soil: columns [x0, x1), rows [y0, y1).
struct Extent {
    int x0 = std::numeric_limits<int>::max(), x1 = 0, y0 = std::numeric_limits<int>::max(), y1 = 0;
};

/// Call work(stencil, divergence) for all cells that hold soil.
template <class Work>
void for_each_cell(const PressureEquations& equations, Work&& work)
{
    for (const TileDivergence& divergence : equations.divergence)
        for (const CellStencil& stencil : divergence.stencils) work(stencil, divergence);
}

Extent extent_of(const BackgroundGrid& grid, const CellLists& lists, const PressureEquations& equations)
{
    Extent extent;
    for_each_cell(equations, [&](const CellStencil& stencil, const TileDivergence&) {
        const int cell = lists.cell_of_slot[static_cast<std::size_t>(stencil.cell)];
        const int x = cell % grid.all_cells_x(), y = cell / grid.all_cells_x();
        extent = {std::min(extent.x0, x), std::max(extent.x1, x + 1), std::min(extent.y0, y),
                  std::max(extent.y1, y + 1)};
    });
    return extent;
}

/// The parts [begin, end) of `length` cells that blocks take, with their overlap.
std::vector<std::pair<int, int>> parts_of(int length)
{
    const int count = (length + largest_block - 1) / largest_block;
    std::vector<std::pair<int, int>> parts;
    for (int k = 0; k < count; ++k) {
        parts.emplace_back(std::max(0, k * length / count - overlap),
                           std::min(length, (k + 1) * length / count + overlap));
    }
    return parts;
}

/// Blocks of equal size, the rows of each counted along its shorter side first for a narrow band.
void divide(const BackgroundGrid& grid, const CellLists& lists, const PressureEquations& equations,
            PressureBlocks& blocks)
{
    const Extent extent = extent_of(grid, lists, equations);
    blocks.blocks_of_slot.assign(lists.cell_of_slot.size(), 0);
    std::vector<bool> filled(lists.cell_of_slot.size(), false);
    for_each_cell(equations, [&](const CellStencil& stencil, const TileDivergence&) {
        filled[static_cast<std::size_t>(stencil.cell)] = true;
    });
    for (const AggregatedCell& cell : equations.aggregated)
        filled[static_cast<std::size_t>(cell.slot)] = false;
    blocks.blocks.clear();
    for (const auto& [bottom, top] : parts_of(extent.y1 - extent.y0)) {
        for (const auto& [left, right] : parts_of(extent.x1 - extent.x0)) {
            CellBlock& block = blocks.blocks.emplace_back();
            const int width = right - left, height = top - bottom;
            for (int k = 0; k < width * height; ++k) {
                const int x = width < height ? k % width : k / height;
                const int y = width < height ? k / width : k % height;
                const int cell = (extent.y0 + bottom + y) * grid.all_cells_x() + extent.x0 + left + x;
                const std::int32_t slot = lists.slot_of_cell[static_cast<std::size_t>(cell)];
                if (!filled[static_cast<std::size_t>(slot)]) continue;
                block.slots.push_back(slot);
                ++blocks.blocks_of_slot[static_cast<std::size_t>(slot)];
            }
        }
    }
}

using StencilOfSlot = std::vector<std::pair<const CellStencil*, const TileDivergence*>>;

/// The touches of a block's cells; badly filled cells touch with the row of their root.
void find_touches(const BackgroundGrid& grid, const CellBlock& block, const StencilOfSlot& stencil_of_slot,
                  const std::vector<AggregatedCell>& aggregated, NodeTouches& touches)
{
    touches.clear();
    std::vector<std::pair<std::size_t, std::int32_t>> cells; // rows and slots
    for (std::size_t row = 0; row < block.slots.size(); ++row) cells.emplace_back(row, block.slots[row]);
    for (const AggregatedCell& cell : aggregated) {
        const auto root = std::find(block.slots.begin(), block.slots.end(), cell.root);
        if (root != block.slots.end())
            cells.emplace_back(static_cast<std::size_t>(root - block.slots.begin()), cell.slot);
    }
    for (const auto& [row, slot] : cells) {
        const auto [cell, D] = stencil_of_slot[static_cast<std::size_t>(slot)];
        if (cell == nullptr) continue;
        auto k = static_cast<std::size_t>(cell->first);
        for (int b = 0; b < cell->height; ++b) {
            const auto first = static_cast<std::size_t>(cell->base + b * grid.nodes_x());
            for (std::size_t a = 0; a < static_cast<std::size_t>(cell->width); ++a, ++k) {
                if (D->x[k] != 0.0 || D->y[k] != 0.0) touches.add(first + a, {row, D->x[k], D->y[k]});
            }
        }
    }
}

std::size_t band_of(const NodeTouches& touches)
{
    std::size_t band = 0;
    touches.for_each([&](std::size_t, const std::vector<Touch>& cells) {
        const auto [low, high] = std::minmax_element(
            cells.begin(), cells.end(), [](const Touch& a, const Touch& b) { return a.row < b.row; });
        band = std::max(band, high->row - low->row);
    });
    return std::min(band, largest_band);
}

/// Call visit(touches) for the touches of a node in groups of rows no farther apart than the band. The
/// products within a group are positive, those that a band alone leaves of them may be negative.
template <class Visit>
void for_each_group(std::vector<Touch> touches, std::size_t band, Visit&& visit)
{
    const auto by_row = [](const Touch& a, const Touch& b) { return a.row < b.row; };
    const auto [low, high] = std::minmax_element(touches.begin(), touches.end(), by_row);
    const bool divides = high->row - low->row > band;
    if (divides) std::stable_sort(touches.begin(), touches.end(), by_row);
    const std::span<const Touch> all(touches);
    for (std::size_t first = 0; first < all.size();) {
        std::size_t last = all.size();
        if (divides)
            for (last = first; last < all.size() && all[last].row <= all[first].row + band;) ++last;
        visit(all.subspan(first, last - first));
        first = last;
    }
}

/// For each of `rows` the first one, no farther than the band, that it may have a product with.
std::vector<std::size_t> first_partners(std::size_t rows, std::size_t band, const NodeTouches& touches)
{
    std::vector<std::size_t> first(rows);
    std::iota(first.begin(), first.end(), std::size_t{0});
    touches.for_each([&](std::size_t, const std::vector<Touch>& cells) {
        std::size_t least = rows;
        for (const Touch& touch : cells) least = std::min(least, touch.row);
        for (const Touch& touch : cells) {
            const std::size_t farthest = touch.row - std::min(touch.row, band);
            first[touch.row] = std::min(first[touch.row], std::max(least, farthest));
        }
    });
    return first;
}

void factorise(double dt, const PressureEquations& equations, const NodeTouches& touches, CellBlock& block)
{
    const std::size_t rows = block.slots.size(), band = band_of(touches);
    block.factor.reset(first_partners(rows, band, touches));
    block.solution.assign(block.factor.vector_length(), 0.0f);
    block.scale.resize(rows);
    std::vector<double> scale(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto slot = static_cast<std::size_t>(block.slots[row]);
        scale[row] = 1.0 / std::sqrt(equations.diagonal[slot]);
        block.factor.add(row, row, equations.storage[slot] / equations.diagonal[slot]);
    }
    const NodeCompliances& W = equations.compliance;
    touches.for_each([&](std::size_t i, const std::vector<Touch>& cells) {
        for_each_group(cells, band, [&](std::span<const Touch> group) {
            for (const Touch& a : group) {
                const double x = W.xx[i] * a.x + W.xy[i] * a.y, y = W.xy[i] * a.x + W.yy[i] * a.y;
                for (const Touch& b : group)
                    if (b.row <= a.row)
                        block.factor.add(a.row, b.row,
                                         scale[a.row] * scale[b.row] * dt * dt * (x * b.x + y * b.y));
            }
        });
    });
    block.factor.factorise(least_pivot);
    set_up_rows(dt, equations.held, touches, scale, block.factor, block.solution, block.rows);
}

void solve_block(const Scalars& residual, CellBlock& block)
{
    for (std::size_t row = 0; row < block.slots.size(); ++row) {
        // scaled in double precision: residuals may be smaller than single precision holds
        const auto slot = static_cast<std::size_t>(block.slots[row]);
        block.solution[row] = static_cast<float>(residual[slot] * static_cast<double>(block.scale[row]));
    }
    block.factor.solve_lower(block.solution.data());
    hold_rows(block.rows, block.solution);
    block.factor.solve_upper(block.solution.data());
}

void add_answer(const CellBlock& block, Scalars& answer)
{
    for (std::size_t row = 0; row < block.slots.size(); ++row) {
        answer[static_cast<std::size_t>(block.slots[row])] +=
            static_cast<double>(block.solution[row]) * static_cast<double>(block.scale[row]);
    }
}

} // namespace

void set_up_blocks(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions,
                   double dt, const PressureEquations& equations, PressureBlocks& blocks)
{
    divide(grid, lists, equations, blocks);
    StencilOfSlot stencil_of_slot(lists.cell_of_slot.size());
    for_each_cell(equations, [&](const CellStencil& stencil, const TileDivergence& divergence) {
        stencil_of_slot[static_cast<std::size_t>(stencil.cell)] = {&stencil, &divergence};
    });
    NodeTouches touches(conditions, equations.following);
    for (CellBlock& block : blocks.blocks) {
        find_touches(grid, block, stencil_of_slot, equations.aggregated, touches);
        factorise(dt, equations, touches, block);
    }
}

void scale_blocks(const Scalars& diagonal, PressureBlocks& blocks)
{
    for (CellBlock& block : blocks.blocks) {
        for (std::size_t row = 0; row < block.slots.size(); ++row) {
            const auto slot = static_cast<std::size_t>(block.slots[row]);
            block.scale[row] =
                static_cast<float>(1.0 / std::sqrt(diagonal[slot] * blocks.blocks_of_slot[slot]));
        }
    }
}

void precondition(const Scalars& residual, PressureBlocks& blocks, Scalars& answer)
{
    std::vector<CellBlock>& all = blocks.blocks;
    std::atomic<std::size_t> next = 0;
    on_threads(all.size() > 1 ? thread_count() : 1, [&] {
        for (std::size_t b = next++; b < all.size(); b = next++) solve_block(residual, all[b]);
    });
    std::fill(answer.begin(), answer.end(), 0.0);
    for (const CellBlock& block : blocks.blocks) add_answer(block, answer);
}

} // namespace quicksand
