// The walk over the nodes of a stored stencil, used by scatter and by gather.
#pragma once

#include "solver/base/lanes.hpp"
#include "solver/interpolation/node_weights.hpp"

namespace quicksand {

/// Call begin_row() and end_row() at the start and end of every row of a stencil and add(node, phi, d phi/dx,
/// d phi/dy) for its nodes, row by row from the lower left one.
template <class Node, class BeginRow, class Add, class EndRow>
inline void walk_stencil(const StoredStencil& stencil, const StencilStore& store, std::int32_t nodes_x,
                         Node* nodes, BeginRow&& begin_row, Add&& add, EndRow&& end_row)
{
    const auto first = static_cast<std::size_t>(stencil.first);
    const double *phi = store.value.data() + first, *grad_x = store.gradient_x.data() + first,
                 *grad_y = store.gradient_y.data() + first;
    const std::int32_t width = stencil.width, height = stencil.height;
    Node* row = nodes + stencil.base(nodes_x);
    for (std::int32_t b = 0; b < height; ++b, row += nodes_x) {
        begin_row();
        for (std::int32_t a = 0; a < width; ++a) add(row[a], phi[a], grad_x[a], grad_y[a]);
        end_row();
        phi += width, grad_x += width, grad_y += width;
    }
}

} // namespace quicksand
