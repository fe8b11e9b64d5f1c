// The elastic stiffness of the skeleton on the bilinear functions of the cells.
//
// On a square cell it does not depend on the size. For the nodes a, b of a cell, the integrals being over the
// unit square,
//   K_xx = M int N_a,x N_b,x + G int N_a,y N_b,y        K_xy = (M - 2G) int N_a,x N_b,y + G int N_a,y N_b,x
// and K_yy, K_yx with x and y exchanged. The mean gradients of particles' domains are softer and
// the moduli those of cell_moduli.hpp, so that K bounds the stiffness that particles feel.
// A domain that passes a node at its corner has no weight at the far corner of the cells beside it. Those
// cells have constant strains, of the nodes that they share with the domain: without them the cells before
// and behind the node could turn against each other, with the domain's stress and without K.
#pragma once

#include "solver/inertia/cell_moduli.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quicksand {

/// A cell with one corner that no particle reaches: 0 and 1 are the lower left and right ones, 2 and 3 those
/// above them.
struct ThreeNodeCell {
    std::size_t place = 0, missing = 0;
    double constrained = 0.0, shear = 0.0; // as CellModuli [Pa]
};

/// A node's row of K: blocks of 2 x 2 on the nodes of the 3 x 3 around it, four nodes side by side.
class NodeStiffness {
public:
    static constexpr std::size_t lanes = NodeRows::lanes;
    static constexpr std::size_t entries = 4;            // of a block: xx, xy, yx, yy
    static constexpr std::size_t per_node = 9 * entries; // of blocks

    /// Set up the rows of the nodes of the spans; the others have none. The moduli of cells with three nodes
    /// stand in their list alone.
    void assemble(const NodeRows& rows, const CellModuli& cells,
                  const std::vector<ThreeNodeCell>& with_three_nodes, std::vector<NodeSpan> spans);

    /// force = factor K velocity on the nodes of the spans. The velocity is read one node beyond them on all
    /// sides.
    void multiply(double factor, const Vectors& velocity, Vectors& force) const;

    /// Call visit(node, place) for the nodes that have a row.
    template <class Visit>
    void for_each_node(Visit&& visit) const
    {
        for (const NodeSpan& span : spans_) {
            const std::size_t row = (span.first - NodeRows::lanes) / rows_.stride;
            const std::size_t start = rows_.place(0, row);
            for (std::size_t k = span.first; k < std::min(span.last, start + rows_.nodes_x); ++k)
                visit(row * rows_.nodes_x + k - start, k);
        }
    }

    /// K(row, column) of that block, with a + 3 b = `neighbour`.
    double entry(std::size_t place, std::size_t neighbour, std::size_t row, std::size_t column) const
    {
        return blocks_[index_of(place, neighbour, row, column)];
    }

    /// The block of the node at a place and of that to the right by a - 1 and up by b - 1.
    Eigen::Matrix2d block(std::size_t place, std::size_t a, std::size_t b) const;

private:
    /// Where that number stands among all of them.
    static std::size_t index_of(std::size_t place, std::size_t neighbour, std::size_t row, std::size_t column)
    {
        return place / lanes * lanes * per_node + (neighbour * entries + row * 2 + column) * lanes +
               place % lanes;
    }
    void add(const ThreeNodeCell& cell);

    NodeRows rows_;
    std::vector<NodeSpan> spans_;
    std::vector<double> blocks_; // [N/m2]
};

} // namespace quicksand
