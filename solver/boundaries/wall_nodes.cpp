#include "solver/boundaries/wall_nodes.hpp"

#include "solver/base/cross_product.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

/// Whether the chain of masters from a node comes to `node`.
bool leads_to(const Masters& masters, std::size_t from, std::size_t node)
{
    while (from != node && masters[from] != from) from = masters[from];
    return from == node;
}

/// Index along the axis of the first row of nodes on or beyond a wall that is parallel to the grid.
int first_row_beyond(const BackgroundGrid& grid, const Segment& wall, int axis)
{
    const double side = outward_normal(wall)[axis];
    const double cells = (wall.start[axis] - grid.rim_origin()[axis]) / grid.cell_size;
    return static_cast<int>(side > 0.0 ? std::ceil(cells - on_wall) : std::floor(cells + on_wall));
}

/// Whether a point lies on a segment.
bool lies_on(const Vector2& point, const Segment& segment, double tolerance)
{
    const Vector2 along = (segment.end - segment.start).normalized(), from_start = point - segment.start;
    const double s = from_start.dot(along);
    return std::abs(cross(along, from_start)) <= tolerance && s >= -tolerance &&
           s <= (segment.end - segment.start).norm() + tolerance;
}

} // namespace

int normal_axis(const Segment& segment)
{
    constexpr double aligned = 1e-9;
    const Vector2 normal = outward_normal(segment);
    if (std::abs(normal.y()) < aligned) return 0;
    return std::abs(normal.x()) < aligned ? 1 : -1;
}

bool holds_nodes(const Problem& problem, const Boundary& boundary, const Segment& segment)
{
    if (moves(boundary.soil)) return false;
    const int axis = normal_axis(segment);
    if (axis < 0) return false;
    const double cells = (segment.start[axis] - problem.grid.rim_origin()[axis]) / problem.grid.cell_size;
    return std::abs(cells - std::round(cells)) <= on_wall;
}

double reach_past(const Problem& problem, const Segment& wall, const Vector2& end)
{
    const double tolerance = on_wall * problem.grid.cell_size;
    const bool forward = end == wall.end;
    const Vector2 along = (forward ? wall.end - wall.start : wall.start - wall.end).normalized();
    constexpr double straight = 0.02; // sine of the smallest turn that counts as a corner [-]
    double sharpest = 1.0;            // sine of the turn towards the soil [-]
    for_each_edge(problem, [&](const Segment& other) {
        const Vector2& shared = forward ? other.start : other.end;
        if ((shared - end).norm() > tolerance) return;
        const Vector2 onward = (forward ? other.end - other.start : other.start - other.end).normalized();
        sharpest = std::min(sharpest, forward ? cross(along, onward) : -cross(along, onward));
    });
    if (sharpest < -straight) return -tolerance;
    return sharpest < straight ? tolerance : std::numeric_limits<double>::infinity();
}

bool enters_soil(const Problem& problem, const Vector2& start, const Vector2& direction, double distance)
{
    const double tolerance = on_wall * problem.grid.cell_size;
    if (distance <= tolerance) return false;
    constexpr double facing = -0.02; // cosine between the way and the normal of an edge that it crosses [-]
    bool enters = false;
    for_each_edge(problem, [&](const Segment& edge) {
        if (enters || outward_normal(edge).dot(direction) > facing) return;
        // start + t direction = edge.start + s along
        const Vector2 to_edge = edge.start - start, along = edge.end - edge.start;
        const double t = cross(to_edge, along) / cross(direction, along);
        const double s = cross(to_edge, direction) / cross(direction, along);
        const double slack = tolerance / along.norm();
        enters = t > tolerance && t <= distance + tolerance && s >= -slack && s <= 1.0 + slack;
    });
    return enters;
}

void tie_beyond(const Problem& problem, const Segment& drawn, const Segment& wall, Masters& masters)
{
    const BackgroundGrid& grid = problem.grid;
    const int axis = normal_axis(wall), first = first_row_beyond(grid, wall, axis);
    const int step = axis == 0 ? 1 : grid.nodes_x();
    for_each_node_held(problem, drawn, wall, [&](std::size_t node) {
        const auto columns = static_cast<std::size_t>(grid.nodes_x());
        const auto index = static_cast<int>(axis == 0 ? node % columns : node / columns);
        if (index == first) return;
        const auto master =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + (first - index) * step);
        // of two walls whose rows lie beyond each other, the first has its way
        if (!leads_to(masters, master, node)) masters[node] = master;
    });
}

bool lies_on_rim(const Problem& problem, const Segment& segment)
{
    const double tolerance = on_wall * problem.grid.cell_size;
    const Vector2 middle = 0.5 * (segment.start + segment.end);
    return std::any_of(problem.rim.begin(), problem.rim.end(),
                       [&](const Segment& edge) { return lies_on(middle, edge, tolerance); });
}

std::vector<Segment> unnamed_edges(const Problem& problem)
{
    const double tolerance = on_wall * problem.grid.cell_size;
    const auto has_name = [&](const Vector2& point) {
        for (const Boundary& boundary : problem.boundaries)
            for (const Segment& segment : boundary.segments)
                if (lies_on(point, segment, tolerance)) return true;
        return false;
    };
    std::vector<Segment> unnamed;
    for (const Segment& edge : problem.rim)
        if (!has_name(0.5 * (edge.start + edge.end))) unnamed.push_back(edge);
    return unnamed;
}

} // namespace quicksand
