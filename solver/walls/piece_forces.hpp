// Forces of the pieces of a curve that have given sums at the nodes: F_k = L_k sum_i w_ki y_i with
// multipliers y of the nodes, such that sum_k w_ki F_k = R_i. The matrix B_ij = sum_k L_k w_ki w_kj of the
// multipliers is symmetric, that of a mass along the curve. Forces at a node that follows others count at
// those: its own mass may be next to nothing.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/walls/velocity_rows.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace quicksand {

/// Where the force of one piece goes, and its length.
struct PieceWeights {
    double length = 0.0;  // 0: a holder [m]
    bool on_line = false; // of the grid, with the whole curve
    std::vector<std::pair<std::size_t, double>> fractions;
};

/// sum_k w_ki F_k at the chosen nodes [N/m].
Scalars sums_at_nodes(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& chosen,
                      const Scalars& forces);

/// Forces of the pieces whose sums at the chosen nodes come near `wanted` [N/m], by iterated Tikhonov
/// regularisation (King & Chillingworth 1979). What pieces carry badly, where the curve cuts cells, they
/// leave: forces far above those wanted that cancel each other at the nodes would do work as points move by a
/// part of a cell, and throw the soil about.
Scalars spread_on_pieces(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& chosen,
                         const Scalars& wanted);

/// The nodes that follow others along an axis: 0 for x, 1 for y.
class FollowingNodes {
public:
    FollowingNodes(const VelocityRows& rows, int axis);

    bool contains(std::size_t node) const { return parts_.contains(node); }

    /// Forces at the followers go to the nodes that they follow.
    void pass_on(Scalars& forces) const;

    /// The same of the forces that pieces share out.
    std::vector<PieceWeights> passed_on(std::vector<PieceWeights> pieces) const;

private:
    std::map<std::size_t, std::vector<std::pair<std::size_t, double>>> parts_; // node and weight, by follower
};

} // namespace quicksand
