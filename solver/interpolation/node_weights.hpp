// The weights of one particle on a rectangular stencil of nodes, whatever the interpolation.
//
// An interpolation is a function object that fills a NodeStencil from a particle's domain; scatter and gather
// use stencils only. Each tile stores its stencils for the step; scatter and gather both use them.
#pragma once

#include "solver/base/conventions.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// phi_ip and its gradient.
struct NodeWeight {
    double value;      // phi_ip [-]
    double gradient_x; // d phi_ip / dx [1/m]
    double gradient_y; // d phi_ip / dy [1/m]
};

/// Weights on width x height nodes, row by row from the lower left one.
struct NodeStencil {
    static constexpr int max_width = 8; // reach of three cells on either side

    std::int32_t column = 0, row = 0; // of the lower left node, from the rim's corner [-]
    std::int32_t width = 0;           // nodes [-]
    std::int32_t height = 0;
    NodeWeight weights[max_width * max_width];
};

/// A stencil in a StencilStore.
struct StoredStencil {
    std::int32_t column, row; // of its lower left node
    std::int32_t first;       // of its weights in the store
    std::int16_t width, height;

    /// Index of the lower left node.
    std::int32_t base(std::int32_t nodes_x) const { return row * nodes_x + column; }
};

/// Lengthen work space to `needed` numbers plus an eighth; a vector by itself would double.
inline void make_room(std::vector<double>& values, std::size_t needed)
{
    if (needed <= values.size()) return;
    values.reserve(needed + needed / 8);
    values.resize(values.capacity());
}

/// The stencils of one tile's particles, in the order of the cell lists. The three parts of the weights
/// have separate arrays, so that rows of a stencil are written four nodes at a time.
struct StencilStore {
    static constexpr std::size_t lanes = 4; // a row may be written this far beyond its end

    std::vector<StoredStencil> stencils;
    std::vector<double> value, gradient_x, gradient_y; // as NodeWeight; longer than what is in use
    std::size_t used = 0;                              // weights of the stencils so far
    std::vector<std::uint32_t> cut;                    // stencils of domains that an outline cuts
    std::int64_t cut_of = -1;                          // CellLists::changes for which they were found

    /// Room for the stencils of so many particles, none of them with weights yet.
    void clear_for(std::size_t particles)
    {
        stencils.resize(particles);
        used = 0;
    }

    /// Make room for a stencil of `count` nodes.
    void extend(std::size_t count)
    {
        const std::size_t needed = used + count + lanes;
        if (needed <= value.size()) return;
        for (std::vector<double>* part : {&value, &gradient_x, &gradient_y}) make_room(*part, needed);
    }

    /// Store the stencil of a particle, counted in the tile, after those of the particles before it.
    void put(std::size_t particle, const NodeStencil& stencil)
    {
        const int count = stencil.width * stencil.height;
        extend(static_cast<std::size_t>(count));
        stencils[particle] = {stencil.column, stencil.row, static_cast<std::int32_t>(used),
                              static_cast<std::int16_t>(stencil.width),
                              static_cast<std::int16_t>(stencil.height)};
        for (int k = 0; k < count; ++k, ++used) {
            value[used] = stencil.weights[k].value;
            gradient_x[used] = stencil.weights[k].gradient_x;
            gradient_y[used] = stencil.weights[k].gradient_y;
        }
    }
};

/// Call visit(node, weight) for the nodes of a stencil.
template <class Visit>
void for_each_node(const StoredStencil& stencil, const StencilStore& store, std::int32_t nodes_x,
                   Visit&& visit)
{
    auto k = static_cast<std::size_t>(stencil.first);
    for (std::int32_t b = 0; b < stencil.height; ++b) {
        const auto row = static_cast<std::size_t>(stencil.base(nodes_x) + b * nodes_x);
        for (std::int32_t a = 0; a < stencil.width; ++a, ++k) {
            visit(row + static_cast<std::size_t>(a),
                  NodeWeight{store.value[k], store.gradient_x[k], store.gradient_y[k]});
        }
    }
}

} // namespace quicksand
