// The nodes of the grid in rows of whole lanes, and the part of each row that carries soil.
#pragma once

#include "solver/base/threads.hpp"
#include "solver/particles/background_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quicksand {

/// Rows of nodes, each lengthened to a multiple of four, with room for four nodes before and behind them all.
/// A cell has the place of its lower left node.
struct NodeRows {
    static constexpr std::size_t lanes = 4;

    std::size_t nodes_x = 0, nodes_y = 0;
    std::size_t stride = 0; // from a node to the one above it

    std::size_t place(std::size_t column, std::size_t row) const { return lanes + row * stride + column; }
    std::size_t place(std::size_t node) const { return place(node % nodes_x, node / nodes_x); }
    std::size_t size() const { return place(0, nodes_y) + lanes; }
};

inline NodeRows make_node_rows(const BackgroundGrid& grid)
{
    const auto nodes_x = static_cast<std::size_t>(grid.nodes_x());
    return {nodes_x, static_cast<std::size_t>(grid.nodes_y()),
            (nodes_x + NodeRows::lanes - 1) / NodeRows::lanes * NodeRows::lanes};
}

/// The smallest rectangle of nodes around those with soil.
struct Extent {
    std::size_t x0, x1, y0, y1; // [x0, x1) x [y0, y1)
};

template <class IsActive>
Extent extent_of(const NodeRows& grid, IsActive&& is_active)
{
    Extent extent{grid.nodes_x, 0, grid.nodes_y, 0};
    for (std::size_t y = 0; y < grid.nodes_y; ++y)
        for (std::size_t x = 0; x < grid.nodes_x; ++x) {
            if (!is_active(y * grid.nodes_x + x)) continue;
            extent = {std::min(extent.x0, x), std::max(extent.x1, x + 1), std::min(extent.y0, y), y + 1};
        }
    return extent;
}

/// The places [first, last) of a row, multiples of four.
struct NodeSpan {
    std::size_t first = 0, last = 0;

    bool operator==(const NodeSpan&) const = default;
};

/// The spans of the rows from the first to the last node for which is_active(node); rows without one have
/// none. The grid's rim is never active.
template <class IsActive>
void find_spans(const NodeRows& rows, IsActive&& is_active, std::vector<NodeSpan>& spans)
{
    spans.clear();
    for (std::size_t row = 0; row < rows.nodes_y; ++row) {
        const std::size_t start = row * rows.nodes_x;
        std::size_t first = 0, last = rows.nodes_x;
        while (first < last && !is_active(start + first)) ++first;
        while (last > first && !is_active(start + last - 1)) --last;
        if (first == last) continue;
        spans.push_back({rows.place(first / NodeRows::lanes * NodeRows::lanes, row),
                         rows.place((last + NodeRows::lanes - 1) / NodeRows::lanes * NodeRows::lanes, row)});
    }
}

/// Call work(k) for the numbers of the spans, on all threads.
template <class Work>
void for_each_span(const std::vector<NodeSpan>& spans, Work&& work)
{
    std::size_t nodes = 0;
    for (const NodeSpan& span : spans) nodes += span.last - span.first;
    const int threads = threads_for(nodes);
    WorkQueues queues(threads, [&](int k, int n) {
        return static_cast<std::uint32_t>(spans.size() * static_cast<std::size_t>(k) /
                                          static_cast<std::size_t>(n));
    });
    on_threads(threads, [&] {
        while (const auto k = queues.take(thread_number())) work(std::size_t{*k});
    });
}

} // namespace quicksand
