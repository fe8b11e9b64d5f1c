// The boundary curves on grid lines as conditions on nodes; all others are chains with rows (wall_rows.hpp).
//
// A wall (fixed or roller) constrains the nodes on it and beyond it, so that particle corners that touch the
// wall see the wall's velocity. A wall goes on straight beyond its ends where the soil's corner is convex:
// soil that rises along a side wall or spreads on the base still meets it.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace quicksand {

/// Conditions on one node, direction by direction; combined by or.
enum NodeCondition : std::uint8_t {
    solid_x_fixed = 1,
    solid_y_fixed = 2,
    fluid_x_fixed = 4,
    fluid_y_fixed = 8,
    seal_x = 16, // a seal: grains and water move together in x; held grains hold the water
    seal_y = 32,
};

/// Nodes with the velocity of another node: the second carries the sum of both.
struct TiedNodes {
    std::size_t node = 0;
    std::size_t master = 0;
};

struct NodeConditions {
    std::vector<std::uint8_t> of_node; // NodeCondition bits, one entry per node
    std::vector<TiedNodes> tied;
    std::vector<std::size_t> master; // of each node: the node that carries its sums, itself mostly
};

/// Whether the water of a node with these conditions moves with the grains alone.
inline bool is_sealed(std::uint8_t conditions)
{
    constexpr std::uint8_t seals = seal_x | seal_y;
    return (conditions & seals) == seals;
}

/// The conditions of a stage: curves that let go hold the soil in the relaxation alone.
NodeConditions node_conditions(const Problem& problem, Stage stage = Stage::shaking);

} // namespace quicksand
