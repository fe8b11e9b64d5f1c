// Which nodes a straight wall holds.
#pragma once

#include "solver/problem/problem.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quicksand {

/// Cells beyond a wall whose nodes it holds: farther than domains reach [-].
inline constexpr double depth_of_wall = 3.5;
/// A node this close to a wall lies on it [cells].
inline constexpr double on_wall = 1e-6;

/// Call visit(segment) for the edges of the soil as drawn, some of them twice.
template <class Visit>
void for_each_edge(const Problem& problem, Visit&& visit)
{
    for (const Boundary& boundary : problem.boundaries) {
        for (const Segment& segment : boundary.segments) visit(segment);
    }
    for (const Segment& segment : problem.rim) visit(segment);
}

/// Whether a straight way through the void, which starts at an edge of the soil, comes to soil again; its
/// direction has the length 1, its distance is in m.
bool enters_soil(const Problem& problem, const Vector2& start, const Vector2& direction, double distance);

/// The axis of a wall's normal where the wall is parallel to the grid, -1 where it is slanted.
int normal_axis(const Segment& segment);

/// Whether a segment is a condition on nodes: it stands, and lies on a line of the grid.
bool holds_nodes(const Problem& problem, const Boundary& boundary, const Segment& segment);

/// How far past `end` (one of its two) a wall holds the nodes beyond it, along itself [m]: without bound
/// where the soil's edge turns to the soil there; to the end where it goes straight on, for the neighbour's
/// own condition holds then; just short of the end where it turns away, for the next nodes lie on the
/// neighbour.
double reach_past(const Problem& problem, const Segment& wall, const Vector2& end);

/// Which node carries the sums of each node: itself, or the node at the wall for nodes beyond it.
using Masters = std::vector<std::size_t>;

/// Nodes beyond the first row of nodes on or beyond a wall, which is parallel to the grid, are tied to that
/// row. A corner beyond the wall then acts on the wall's node; a node beyond the wall has no soil
/// behind it to balance its stress and would accelerate along the wall. `drawn` is the wall as the
/// problem has it, `wall` as it stands now.
void tie_beyond(const Problem& problem, const Segment& drawn, const Segment& wall, Masters& masters);

/// Whether soil ends along a curve's segment; others lie between two regions.
bool lies_on_rim(const Problem& problem, const Segment& segment);

/// The edges of the soil's rim that no boundary has.
std::vector<Segment> unnamed_edges(const Problem& problem);

/// Calls hold(node) for the nodes on and beyond a wall, as far as the void goes; those of the first row in
/// any case.
template <class Hold>
void for_each_node_held(const Problem& problem, const Segment& drawn, const Segment& wall, Hold&& hold);

template <class Hold>
void for_each_node_held(const Problem& problem, const Segment& drawn, const Segment& wall, Hold&& hold)
{
    const BackgroundGrid& grid = problem.grid;
    const double h = grid.cell_size, tolerance = on_wall * h, length = (wall.end - wall.start).norm();
    const Vector2 along = (wall.end - wall.start) / length, normal = outward_normal(wall);
    const double before = reach_past(problem, drawn, drawn.start),
                 after = reach_past(problem, drawn, drawn.end);
    for (int j = 0; j < grid.nodes_y(); ++j) {
        for (int i = 0; i < grid.nodes_x(); ++i) {
            const Vector2 from_start = grid.node_position(i, j) - wall.start;
            const double beyond = from_start.dot(normal), along_wall = from_start.dot(along);
            const double least = beyond <= tolerance ? tolerance : -h; // both ends are the wall's own
            const bool near = beyond >= -tolerance && beyond <= depth_of_wall * h + tolerance &&
                              along_wall >= -std::max(before, least) &&
                              along_wall <= length + std::max(after, least);
            if (!near || enters_soil(problem, wall.start, -along, -along_wall) ||
                enters_soil(problem, wall.end, along, along_wall - length))
                continue;
            const bool first_row = beyond < h - tolerance;
            const Vector2 foot = wall.start + along_wall * along;
            if (first_row || !enters_soil(problem, foot, normal, beyond)) hold(grid.node_index(i, j));
        }
    }
}

} // namespace quicksand
