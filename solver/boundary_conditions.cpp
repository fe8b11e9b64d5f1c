#include "solver/boundary_conditions.hpp"

#include "solver/failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace quicksand {

namespace {

constexpr double depth_of_wall =
    3.5;                         // cells beyond a wall whose nodes it holds: farther than domains reach [-]
constexpr double on_line = 1e-6; // a node this close to a wall lies on it [cells]

Vector2 outward_normal(const Segment& segment)
{
    // the soil lies to the left of the segment
    const Vector2 along = (segment.end - segment.start).normalized();
    return {along.y(), -along.x()};
}

double cross(const Vector2& a, const Vector2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether the wall may go on straight beyond `end`: no other segment starts there that turns away from the
/// soil (a re-entrant corner) or goes straight on (the neighbour's own condition holds there).
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

std::uint8_t conditions_of(const Boundary& boundary)
{
    std::uint8_t normal = 0, across = 0;
    const bool sealed = boundary.water == WaterCondition::impervious;
    switch (boundary.soil) {
    case SoilCondition::fixed:
        across = solid_y_fixed;
        [[fallthrough]];
    case SoilCondition::roller:
        normal = static_cast<std::uint8_t>(solid_x_fixed | (sealed ? fluid_x_fixed : 0));
        break;
    case SoilCondition::free:
        normal = sealed ? film_x : 0;
        break;
    case SoilCondition::tied:
        break;
    }
    return normal | across;
}

/// The same conditions for a wall whose normal is the y axis.
std::uint8_t turned(std::uint8_t conditions)
{
    std::uint8_t result = 0;
    if (conditions & solid_x_fixed) result |= solid_y_fixed;
    if (conditions & solid_y_fixed) result |= solid_x_fixed;
    if (conditions & fluid_x_fixed) result |= fluid_y_fixed;
    if (conditions & film_x) result |= film_y;
    return result;
}

/// Calls hold(node) for the nodes on and beyond a segment.
template <class Hold>
void for_each_node_held(const Problem& problem, const Segment& segment, Hold&& hold)
{
    const BackgroundGrid& grid = problem.grid;
    const double h = grid.cell_size, length = (segment.end - segment.start).norm();
    const Vector2 along = (segment.end - segment.start) / length, normal = outward_normal(segment);
    constexpr double far = std::numeric_limits<double>::infinity();
    const double before = goes_on(problem, segment, segment.start, on_line * h) ? far : on_line * h;
    const double after = goes_on(problem, segment, segment.end, on_line * h) ? far : on_line * h;
    for (int j = 0; j < grid.nodes_y(); ++j) {
        for (int i = 0; i < grid.nodes_x(); ++i) {
            const Vector2 from_start = grid.node_position(i, j) - segment.start;
            const double beyond = from_start.dot(normal), along_wall = from_start.dot(along);
            const bool held = beyond >= -on_line * h && beyond <= (depth_of_wall + on_line) * h &&
                              along_wall >= -before && along_wall <= length + after;
            if (held)
                hold(static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nodes_x()) +
                     static_cast<std::size_t>(i));
        }
    }
}

/// Which node carries the sums of each node: itself, or the node at the wall for nodes beyond it.
using Masters = std::vector<std::size_t>;

/// Nodes beyond the first row of nodes that an aligned wall holds are tied to that row. A corner that sticks
/// out through the wall then weighs on the wall's node; a node out there has no soil behind it to balance its
/// stress, and would be shot away along the wall.
void tie_beyond(const Problem& problem, const Segment& segment, int direction, Masters& masters)
{
    const BackgroundGrid& grid = problem.grid;
    const double h = grid.cell_size, side = outward_normal(segment)[direction];
    const double wall = (segment.start[direction] - grid.rim_origin()[direction]) / h;
    const int first = static_cast<int>(side > 0.0 ? std::ceil(wall - on_line) : std::floor(wall + on_line));
    const int step = direction == 0 ? 1 : grid.nodes_x();
    for_each_node_held(problem, segment, [&](std::size_t node) {
        const auto columns = static_cast<std::size_t>(grid.nodes_x());
        const auto index = static_cast<int>(direction == 0 ? node % columns : node / columns);
        if (index == first) return;
        masters[node] = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + (first - index) * step);
    });
}

void add_segment(const Problem& problem, const Segment& segment, std::uint8_t conditions,
                 NodeConditions& result, Masters& masters)
{
    const Vector2 normal = outward_normal(segment);
    constexpr double aligned = 1e-9;
    const bool is_wall = (conditions & (solid_x_fixed | solid_y_fixed)) != 0;
    if (std::abs(normal.y()) < aligned) {
        for_each_node_held(problem, segment, [&](std::size_t node) { result.of_node[node] |= conditions; });
        if (is_wall) tie_beyond(problem, segment, 0, masters);
    } else if (std::abs(normal.x()) < aligned) {
        for_each_node_held(problem, segment,
                           [&](std::size_t node) { result.of_node[node] |= turned(conditions); });
        if (is_wall) tie_beyond(problem, segment, 1, masters);
    } else {
        for_each_node_held(problem, segment, [&](std::size_t node) {
            result.slanted.push_back({node, normal, conditions});
        });
    }
}

/// Columns a whole number of widths apart are the same column of the laminar box.
void tie_sides(const Problem& problem, Masters& masters)
{
    const BackgroundGrid& grid = problem.grid;
    const auto column = [&](double x) {
        return static_cast<int>(std::lround((x - grid.rim_origin().x()) / grid.cell_size));
    };
    const int left = column(problem.tied_sides->x_left);
    const int width = column(problem.tied_sides->x_right) - left;
    ENSURE(width > 0);
    for (int j = 0; j < grid.nodes_y(); ++j) {
        const std::size_t row = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nodes_x());
        for (int i = 0; i < grid.nodes_x(); ++i) {
            const int master = left + ((i - left) % width + width) % width;
            const std::size_t node = row + static_cast<std::size_t>(i);
            // a node below the base is tied to the base already, and its master there to the column
            if (master != i && masters[node] == node) masters[node] = row + static_cast<std::size_t>(master);
        }
    }
}

/// The ties with every chain of masters followed to its end.
std::vector<TiedNodes> resolve(const Masters& masters)
{
    std::vector<TiedNodes> tied;
    for (std::size_t node = 0; node < masters.size(); ++node) {
        std::size_t master = masters[node];
        while (masters[master] != master) master = masters[master];
        if (master != node) tied.push_back({node, master});
    }
    return tied;
}

} // namespace

NodeConditions node_conditions(const Problem& problem)
{
    NodeConditions result;
    result.of_node.assign(problem.grid.node_count(), 0);
    Masters masters(problem.grid.node_count());
    std::iota(masters.begin(), masters.end(), std::size_t{0});
    for (const Boundary& boundary : problem.boundaries) {
        const std::uint8_t conditions = conditions_of(boundary);
        if (conditions == 0) continue;
        for (const Segment& segment : boundary.segments)
            add_segment(problem, segment, conditions, result, masters);
    }
    if (problem.tied_sides) tie_sides(problem, masters);
    result.tied = resolve(masters);
    return result;
}

} // namespace quicksand
