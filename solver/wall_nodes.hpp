// Which nodes a straight wall holds.
#pragma once

#include "solver/problem.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace quicksand {

/// Cells beyond a wall whose nodes it holds: farther than domains reach [-].
inline constexpr double depth_of_wall = 3.5;
/// A node this close to a wall lies on it [cells].
inline constexpr double on_wall = 1e-6;

/// The normal of a segment out of the soil, which lies to its left.
Vector2 outward_normal(const Segment& segment);

/// The axis of a wall's normal where the wall is parallel to the grid, -1 where it is slanted.
int normal_axis(const Segment& segment);

/// Whether a wall may go on straight beyond `end` (one of its two): no other segment starts there that turns
/// away from the soil (a re-entrant corner) or goes straight on (the neighbour's own condition holds there).
bool goes_on(const Problem& problem, const Segment& wall, const Vector2& end, double tolerance);

/// Which node carries the sums of each node: itself, or the node at the wall for nodes beyond it.
using Masters = std::vector<std::size_t>;

/// Nodes beyond the first row of nodes on or beyond a wall, which is parallel to the grid, are tied to that
/// row. A corner that sticks out through the wall then weighs on the wall's node; a node out there has no
/// soil behind it to balance its stress, and would be shot away along the wall. `drawn` is the wall as the
/// problem has it, `wall` as it stands now.
void tie_beyond(const Problem& problem, const Segment& drawn, const Segment& wall, Masters& masters);

/// Index along the axis of the first row of nodes on or beyond a wall that is parallel to the grid.
int first_row_beyond(const BackgroundGrid& grid, const Segment& wall, int axis);

/// Calls hold(node) for the nodes on and beyond a wall.
template <class Hold>
void for_each_node_held(const Problem& problem, const Segment& drawn, const Segment& wall, Hold&& hold);

template <class Hold>
void for_each_node_held(const Problem& problem, const Segment& drawn, const Segment& wall, Hold&& hold)
{
    const BackgroundGrid& grid = problem.grid;
    const double h = grid.cell_size, length = (wall.end - wall.start).norm();
    const Vector2 along = (wall.end - wall.start) / length, normal = outward_normal(wall);
    constexpr double far = std::numeric_limits<double>::infinity();
    const double before = goes_on(problem, drawn, drawn.start, on_wall * h) ? far : on_wall * h;
    const double after = goes_on(problem, drawn, drawn.end, on_wall * h) ? far : on_wall * h;
    for (int j = 0; j < grid.nodes_y(); ++j) {
        for (int i = 0; i < grid.nodes_x(); ++i) {
            const Vector2 from_start = grid.node_position(i, j) - wall.start;
            const double beyond = from_start.dot(normal), along_wall = from_start.dot(along);
            const bool held = beyond >= -on_wall * h && beyond <= (depth_of_wall + on_wall) * h &&
                              along_wall >= -before && along_wall <= length + after;
            if (held)
                hold(static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nodes_x()) +
                     static_cast<std::size_t>(i));
        }
    }
}

} // namespace quicksand
