// The boundary curves as conditions on nodes.
//
// A wall (fixed or roller) constrains the nodes on it and beyond it, so that particle corners that touch the
// wall see the wall's velocity. A wall goes on straight beyond its ends where the soil's corner is convex:
// soil that rises along a side wall or spreads on the base still meets it. A wall off the grid lines acts at
// the first nodes beyond it.
#pragma once

#include "solver/problem.hpp"
#include "solver/state.hpp"

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
    film_x = 16, // an impervious film: grains and water move together in x; held grains hold the water
    film_y = 32,
};

/// Conditions normal to a slanted wall.
struct SlantedNode {
    std::size_t node = 0;
    Vector2 normal = Vector2::Zero(); // outward [-]
    std::uint8_t conditions = 0;      // the _x conditions act along the normal, the _y ones across
};

/// Nodes that share one velocity with another: the second carries the sum of both.
struct TiedNodes {
    std::size_t node = 0;
    std::size_t master = 0;
};

/// A pair of nodes that a moving wall holds, on either side of it; one node where the wall is slanted.
struct WallNode {
    std::size_t inner = 0, outer = 0;
    std::size_t boundary = 0, segment = 0; // the wall, in Problem::boundaries
    Vector2 normal = Vector2::Zero();      // outward [-]
    WallGrip grip = WallGrip::rough;
    bool sealed = false;                // the water moves with the wall
    double outer_share = 1.0;           // the wall's distance from the inner node [cells]
    Vector2 velocity = Vector2::Zero(); // of the wall over the step [m/s]
};

struct NodeConditions {
    std::vector<std::uint8_t> of_node; // NodeCondition bits, one entry per node
    std::vector<SlantedNode> slanted;  // of nodes without other conditions, one a node
    std::vector<TiedNodes> tied;
    std::vector<std::size_t> master;     // of each node: the node that carries its sums, itself mostly
    std::vector<WallNode> walls;         // of moving walls, see moving_walls.hpp
    std::vector<std::int64_t> wall_rows; // for which rows the walls' nodes were found
};

/// The conditions of a stage with the moving walls where they are at `time` [s]. While the soil settles,
/// viscous curves are held: bases fixed, steep sides as rollers.
NodeConditions node_conditions(const Problem& problem, Stage stage = Stage::shaking, double time = 0.0);

} // namespace quicksand
