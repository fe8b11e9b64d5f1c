#include "solver/wall_nodes.hpp"

#include "solver/cross_product.hpp"

#include <cmath>

namespace quicksand {

Vector2 outward_normal(const Segment& segment)
{
    const Vector2 along = (segment.end - segment.start).normalized();
    return {along.y(), -along.x()};
}

int normal_axis(const Segment& segment)
{
    constexpr double aligned = 1e-9;
    const Vector2 normal = outward_normal(segment);
    if (std::abs(normal.y()) < aligned) return 0;
    return std::abs(normal.x()) < aligned ? 1 : -1;
}

bool goes_on(const Problem& problem, const Segment& wall, const Vector2& end, double tolerance)
{
    const bool forward = end == wall.end;
    const Vector2 along = (forward ? wall.end - wall.start : wall.start - wall.end).normalized();
    constexpr double straight = 0.02; // sine of the smallest turn that counts as a corner [-]
    for (const Boundary& boundary : problem.boundaries) {
        for (const Segment& other : boundary.segments) {
            const Vector2& shared = forward ? other.start : other.end;
            if ((shared - end).norm() > tolerance) continue;
            const Vector2 onward = (forward ? other.end - other.start : other.start - other.end).normalized();
            const double turn = forward ? cross(along, onward) : -cross(along, onward);
            if (turn < straight) return false;
        }
    }
    return true;
}

int first_row_beyond(const BackgroundGrid& grid, const Segment& wall, int axis)
{
    const double side = outward_normal(wall)[axis];
    const double cells = (wall.start[axis] - grid.rim_origin()[axis]) / grid.cell_size;
    return static_cast<int>(side > 0.0 ? std::ceil(cells - on_wall) : std::floor(cells + on_wall));
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
        masters[node] = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + (first - index) * step);
    });
}

} // namespace quicksand
