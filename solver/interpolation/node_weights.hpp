// The weights of one particle on a rectangular patch of nodes, whatever the interpolation.
//
// An interpolation is a function object that fills a NodePatch from a particle's domain; scatter and gather
// only see patches. Patches are kept for a step in one store per tile, so that scatter and gather share them.
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
struct NodePatch {
    static constexpr int max_width = 8; // reach of three cells on either side

    std::int32_t column = 0, row = 0; // of the lower left node, from the rim's corner [-]
    std::int32_t width = 0;           // nodes [-]
    std::int32_t height = 0;
    NodeWeight weights[max_width * max_width];
};

/// A patch in a PatchStore.
struct StoredPatch {
    std::int32_t column, row; // of its lower left node
    std::int32_t first;       // of its weights in the store
    std::int16_t width, height;

    /// Index of the lower left node.
    std::int32_t base(std::int32_t nodes_x) const { return row * nodes_x + column; }
};

/// Lengthen work space to `needed` numbers and an eighth to spare; left to itself a vector doubles.
inline void make_room(std::vector<double>& values, std::size_t needed)
{
    if (needed <= values.size()) return;
    values.reserve(needed + needed / 8);
    values.resize(values.capacity());
}

/// The patches of one tile's particles, in the order of the cell lists. The three parts of the weights stand
/// in arrays of their own, so that rows of a patch are written four nodes at a time.
struct PatchStore {
    static constexpr std::size_t lanes = 4; // a row may be written this far beyond its end

    std::vector<StoredPatch> patches;
    std::vector<double> value, gradient_x, gradient_y; // as NodeWeight; longer than what is in use
    std::size_t used = 0;                              // weights of the patches so far
    std::vector<std::uint32_t> cut;                    // patches of domains that an outline cuts
    std::int64_t cut_of = -1;                          // CellLists::changes for which they were found

    /// Room for the patches of so many particles, none of them with weights yet.
    void clear_for(std::size_t particles)
    {
        patches.resize(particles);
        used = 0;
    }

    /// Make room for a patch of `count` nodes.
    void extend(std::size_t count)
    {
        const std::size_t needed = used + count + lanes;
        if (needed <= value.size()) return;
        for (std::vector<double>* part : {&value, &gradient_x, &gradient_y}) make_room(*part, needed);
    }

    /// Store the patch of a particle, counted in the tile, after those of the particles before it.
    void put(std::size_t particle, const NodePatch& patch)
    {
        const int count = patch.width * patch.height;
        extend(static_cast<std::size_t>(count));
        patches[particle] = {patch.column, patch.row, static_cast<std::int32_t>(used),
                             static_cast<std::int16_t>(patch.width), static_cast<std::int16_t>(patch.height)};
        for (int k = 0; k < count; ++k, ++used) {
            value[used] = patch.weights[k].value;
            gradient_x[used] = patch.weights[k].gradient_x;
            gradient_y[used] = patch.weights[k].gradient_y;
        }
    }
};

/// Call visit(node, weight) for the nodes of a patch.
template <class Visit>
void for_each_node(const StoredPatch& patch, const PatchStore& store, std::int32_t nodes_x, Visit&& visit)
{
    auto k = static_cast<std::size_t>(patch.first);
    for (std::int32_t b = 0; b < patch.height; ++b) {
        const auto row = static_cast<std::size_t>(patch.base(nodes_x) + b * nodes_x);
        for (std::int32_t a = 0; a < patch.width; ++a, ++k) {
            visit(row + static_cast<std::size_t>(a),
                  NodeWeight{store.value[k], store.gradient_x[k], store.gradient_y[k]});
        }
    }
}

} // namespace quicksand
