#include "solver/boundaries/boundary_conditions.hpp"

#include "solver/base/failure.hpp"
#include "solver/boundaries/seal_ends.hpp"
#include "solver/boundaries/wall_nodes.hpp"

#include <cmath>
#include <numeric>

namespace quicksand {

namespace {

std::uint8_t conditions_of(const WallHold& hold)
{
    std::uint8_t bits = 0;
    if (hold.grains != GrainHold::none) bits |= solid_x_fixed;
    if (hold.grains == GrainHold::all) bits |= solid_y_fixed;
    if (hold.water == WaterHold::sealed) bits |= fluid_x_fixed;
    if (hold.water == WaterHold::with_grains) bits |= seal_x;
    return bits;
}

/// The same with x and y exchanged.
std::uint8_t turned(std::uint8_t conditions)
{
    constexpr unsigned all_x = solid_x_fixed | fluid_x_fixed | seal_x;
    constexpr unsigned all_y = solid_y_fixed | fluid_y_fixed | seal_y;
    return static_cast<std::uint8_t>((conditions & all_x) << 1 | (conditions & all_y) >> 1);
}

void add_segment(const Problem& problem, const Segment& segment, const WallHold& hold, Stage stage,
                 NodeConditions& result)
{
    const bool seal = hold.water == WaterHold::with_grains;
    const double length = (segment.end - segment.start).norm(), tolerance = on_wall * problem.grid.cell_size;
    const double before = seal ? drained_end(problem, segment, false, length, stage) : 0.0,
                 after = seal ? drained_end(problem, segment, true, length, stage) : 0.0;
    const Vector2 along = (segment.end - segment.start) / length;
    const std::uint8_t conditions =
        normal_axis(segment) == 0 ? conditions_of(hold) : turned(conditions_of(hold));
    for_each_node_held(problem, segment, segment, [&](std::size_t node) {
        const double s = (problem.grid.node_position(node) - segment.start).dot(along);
        const bool drains =
            (before > 0.0 && s < before - tolerance) || (after > 0.0 && s > length - after + tolerance);
        if (!drains) result.of_node[node] |= conditions;
    });
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

/// Follow every chain of masters to its end and list the ties.
std::vector<TiedNodes> resolve(Masters& masters)
{
    std::vector<TiedNodes> tied;
    for (std::size_t node = 0; node < masters.size(); ++node) {
        std::size_t master = masters[node];
        while (masters[master] != master) master = masters[master];
        masters[node] = master;
        if (master != node) tied.push_back({node, master});
    }
    return tied;
}

} // namespace

NodeConditions node_conditions(const Problem& problem, Stage stage)
{
    NodeConditions result;
    result.of_node.assign(problem.grid.node_count(), 0);
    Masters masters(problem.grid.node_count());
    std::iota(masters.begin(), masters.end(), std::size_t{0});
    for (const Boundary& boundary : problem.boundaries) {
        for (const Segment& segment : boundary.segments) {
            if (!holds_nodes(problem, boundary, segment)) continue;
            const WallHold hold = hold_of(boundary, segment, stage);
            if (hold.any()) add_segment(problem, segment, hold, stage, result);
            if (hold.grains != GrainHold::none || lets_go(boundary.soil))
                tie_beyond(problem, segment, segment, masters);
        }
    }
    if (problem.tied_sides) tie_sides(problem, masters);
    result.tied = resolve(masters);
    result.master = std::move(masters);
    return result;
}

} // namespace quicksand
