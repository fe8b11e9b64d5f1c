// The weights of one particle on a rectangular patch of nodes, whatever the interpolation.
//
// An interpolation is a function object that fills a NodePatch from a particle's domain; scatter and gather
// only see patches. Patches are kept for a step in one store per tile, so that scatter and gather share them.
#pragma once

#include "solver/conventions.hpp"

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

/// Weights on width x height nodes, row by row from the node `base`.
struct NodePatch {
    static constexpr int max_width = 8; // reach of three cells on either side

    std::int32_t base = 0;  // node index of the lower left node [-]
    std::int32_t width = 0; // nodes [-]
    std::int32_t height = 0;
    double offset_x = 0.0; // x_base - x_p [m]
    double offset_y = 0.0;
    NodeWeight weights[max_width * max_width];
};

/// A patch in a PatchStore.
struct StoredPatch {
    std::int32_t base, width, height;
    std::int32_t first; // into PatchStore::weights
    double offset_x, offset_y;
};

/// The patches of one tile's particles, in the order of the cell lists.
struct PatchStore {
    std::vector<StoredPatch> patches;
    std::vector<NodeWeight> weights;

    void clear()
    {
        patches.clear();
        weights.clear();
    }
    void push_back(const NodePatch& patch)
    {
        patches.push_back({patch.base, patch.width, patch.height, static_cast<std::int32_t>(weights.size()),
                           patch.offset_x, patch.offset_y});
        weights.insert(weights.end(), patch.weights, patch.weights + patch.width * patch.height);
    }
};

} // namespace quicksand
