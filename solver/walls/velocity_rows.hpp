// Linear conditions on the velocities of several nodes, solved together.
//
//   sum_i c_ri . u_i = V_r,   u_i = (v_s, v_w) of node i
//   v = v* - A^-1 C^T lambda,   P lambda = C v* - V,   P = C A^-1 C^T
//
// A_i is the matrix of a node: masses, implicit drag and dashpots, with the conditions on the node alone
// inside. P is symmetric and positive definite except for linearly dependent rows; it is sparse, for a row
// touches its neighbours along the boundary, and is factorised in every step.
#pragma once

#include "solver/particles/particles.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace quicksand {

using NodeVelocities = Eigen::Vector4d; // v_s and v_w of a node [m/s]
using NodeInverse = Eigen::Matrix4d;    // A^-1: velocities per impulse on grains and water [1/kg]

/// A row's part at a node, those of its followers included.
struct HeldNode {
    std::size_t node = 0;
    NodeVelocities coefficients; // c
    NodeVelocities velocities;   // A^-1 c [1/kg]
    Vector2 flux;                // beta^T A^-1 c [1/kg]
};
/// A row, or the weights of a follower on the nodes that it follows.
struct HeldRow {
    std::vector<HeldNode> nodes; // each once
    double compliance = 0.0;     // of the follower's grains; 0: a row, which nothing moves [1/kg]
};

class VelocityRows {
public:
    struct Entry {
        std::size_t place; // of the node among those of the rows
        NodeVelocities coefficients;
    };

    /// No rows on no nodes.
    void clear(std::size_t node_count);

    /// Begin a row with its value V; add() goes to the last one.
    void begin_row(double value);
    void add(std::size_t node, const NodeVelocities& coefficients);
    /// From here on rows let their first node follow the others.
    void begin_followers() { first_follower_ = size(); }

    /// Call visit(follower, direction, node, weight) for every node that a follower follows along a direction
    /// of NodeVelocities, those of one follower and direction after each other.
    template <class Visit>
    void for_each_followed(Visit&& visit) const
    {
        for_each_follower([&](std::size_t row, std::size_t follower, int direction) {
            for (std::size_t k = first_[row] + 1; k < end_of(row); ++k)
                visit(nodes_[follower], direction, nodes_[entries_[k].place],
                      -entries_[k].coefficients[direction]);
        });
    }

    /// Call visit(row, node, coefficients) for all parts of all rows; a node may have several in a row.
    template <class Visit>
    void for_each_coefficient(Visit&& visit) const
    {
        for (std::size_t row = 0; row < size(); ++row)
            for (std::size_t k = first_[row]; k < end_of(row); ++k)
                visit(row, nodes_[entries_[k].place], entries_[k].coefficients);
    }

    bool empty() const { return values_.empty(); }
    std::size_t size() const { return values_.size(); }
    const std::vector<std::size_t>& nodes() const { return nodes_; }
    /// Where one of them stands among nodes().
    std::size_t place(std::size_t node) const { return static_cast<std::size_t>(place_of_node_[node]); }

    /// Set P up and factorise it; `inverses` are those of nodes(), in their order. Rows that act on nothing
    /// are left out.
    void factorise(std::vector<NodeInverse> inverses);

    /// Smallest pivot of P, scaled to a diagonal of ones: small where rows nearly repeat each other [-].
    double smallest_pivot() const { return smallest_pivot_; }
    /// Whether it is so small that rows yield to their multipliers.
    bool repeat() const;

    /// What a row yields by its multiplier where rows nearly repeat each other: c . u + softness multiplier
    /// is its value [m/s per N s].
    double softness(std::size_t row) const;

    const NodeInverse& inverse(std::size_t place) const { return inverses_[place]; }

    double value(std::size_t row) const { return values_[row]; }
    void set_value(std::size_t row, double value) { values_[row] = value; }
    /// sum c . u of a row, for velocities at nodes().
    double product(std::size_t row, const std::vector<NodeVelocities>& velocities) const;
    /// Give followers the velocities that their rows ask for.
    void extrapolate(std::vector<NodeVelocities>& velocities) const;

    /// Impulses on the nodes: - C^T multipliers [N s].
    std::vector<NodeVelocities> impulses(const Scalars& multipliers) const;

    /// Make the velocities meet the rows' values.
    void hold(std::vector<NodeVelocities>& velocities) const;
    /// Project velocities (or accelerations) on those that meet the rows with values of zero; returns the
    /// multipliers of the rows that do it [N s].
    Scalars project(std::vector<NodeVelocities>& velocities) const;

    /// Set up the response to forces of the pressure: a force f on node i is the impulse (1-n) f, n f;
    /// porosities by nodes().
    void set_porosities(const Scalars& porosities);
    /// Response of each node to a force of the pressure without the rows, and of followers by the nodes that
    /// they follow; without coupling between nodes, for preconditioners.
    std::vector<Eigen::Matrix2d> local_compliances() const;
    /// The rows before the followers', with what followers have of them at the nodes that they follow.
    std::vector<HeldRow> held_rows() const;
    /// flux at nodes() = (W - B^T P^-1 B) force, for forces of the pressure at them.
    void respond_to_pressure(const std::vector<Vector2>& force, std::vector<Vector2>& flux) const;

private:
    /// Two entries at one node, whose product is part of P.
    struct Product {
        std::size_t a, b;   // of the entries
        std::size_t target; // among the matrix's values
    };
    /// Where the rows' products go in the matrix, as long as rows touch the same nodes in the same
    /// directions.
    struct Pattern {
        std::vector<std::size_t> first, places; // of the rows that it was made for
        std::vector<std::uint8_t> axes;         // of their entries, see axes_of()
        bool turns = false;                     // whether impulses along one axis move nodes along the other
        std::vector<Product> products;
        std::vector<std::size_t> diagonal; // among the matrix's values
    };
    struct Factor {
        Pattern pattern;
        Eigen::SparseMatrix<double> matrix; // the lower half of P, scaled
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
    };

    std::size_t end_of(std::size_t row) const { return row + 1 < size() ? first_[row + 1] : entries_.size(); }
    /// Call visit(row, place, direction) for the rows of followers with the places of their nodes; directions
    /// are 0 and 1 of the grains, 2 and 3 of the water. The row's other entries are those of the nodes that
    /// it follows.
    template <class Visit>
    void for_each_follower(Visit&& visit) const
    {
        for (std::size_t row = first_follower_; row < size(); ++row) {
            const Entry& own = entries_[first_[row]];
            int direction = 3; // the row of the water may have its velocity against the grains
            while (direction > 0 && own.coefficients[direction] == 0.0) --direction;
            visit(row, own.place, direction);
        }
    }
    HeldNode held_node(std::size_t place, const NodeVelocities& c) const;
    template <class Visit>
    void for_each_entry_of(std::size_t row, Visit&& visit) const;
    template <class Visit>
    void for_each_entry(Visit&& visit) const;
    Scalars products(const std::vector<NodeVelocities>& velocities) const;
    Scalars misses(bool to_zero, const std::vector<NodeVelocities>& velocities) const;
    Scalars solve(Scalars right_hand_side) const;
    Scalars correct(bool to_zero, std::vector<NodeVelocities>& velocities) const; // the multipliers
    bool inverses_turn() const;
    bool is_made_for_rows(const Pattern& pattern, bool turns) const;
    void choose_factor(bool turns);
    void find_pattern(bool turns, Factor& factor) const;
    void fill_matrix();

    std::vector<std::size_t> nodes_;
    std::vector<std::int32_t> place_of_node_; // -1: in no row
    std::vector<NodeInverse> inverses_;
    std::vector<double> values_;               // V of the rows
    std::size_t first_follower_ = 0;           // row
    std::vector<std::size_t> first_;           // entry of each row
    std::vector<Entry> entries_;               // row by row
    std::vector<NodeVelocities> responses_;    // A^-1 c of the entries [1/kg]
    std::vector<Vector2> by_pressure_;         // B of the entries: beta^T A^-1 c [1/kg]
    Scalars porosities_;                       // of nodes() [-]
    std::vector<Eigen::Matrix2d> compliances_; // of nodes() without the rows: beta^T A^-1 beta [1/kg]
    Scalars scale_; // of the rows, 0 of those left out: P scaled has a diagonal of ones
    // the last used first; copies of the rows share them
    std::vector<std::shared_ptr<Factor>> factors_;
    double smallest_pivot_ = 1.0; // of P scaled [-]
};

} // namespace quicksand
