#include "solver/boundary_conditions.hpp"

#include "solver/failure.hpp"
#include "solver/moving_walls.hpp"
#include "solver/wall_corners.hpp"
#include "solver/wall_nodes.hpp"

#include <cmath>
#include <numeric>

namespace quicksand {

namespace {

/// A viscous curve while the soil settles: as the standard fixities of a section, a base is fixed and a side
/// slides.
SoilCondition held_while_settling(const Segment& segment)
{
    const Vector2 normal = outward_normal(segment);
    return std::abs(normal.y()) >= std::abs(normal.x()) ? SoilCondition::fixed : SoilCondition::roller;
}

SoilCondition condition_in(Stage stage, const Boundary& boundary, const Segment& segment)
{
    const bool settles = boundary.soil == SoilCondition::viscous && stage == Stage::relaxation;
    return settles ? held_while_settling(segment) : boundary.soil;
}

std::uint8_t conditions_of(SoilCondition soil, WaterCondition water)
{
    std::uint8_t normal = 0, across = 0;
    const bool sealed = water == WaterCondition::impervious;
    switch (soil) {
    case SoilCondition::fixed:
        across = solid_y_fixed;
        [[fallthrough]];
    case SoilCondition::roller:
        normal = static_cast<std::uint8_t>(solid_x_fixed | (sealed ? fluid_x_fixed : 0));
        break;
    case SoilCondition::free:
    case SoilCondition::viscous:
        normal = sealed ? film_x : 0;
        break;
    case SoilCondition::tied:
    case SoilCondition::moving: // held after the momentum balance
        break;
    }
    return normal | across;
}

void add_segment(const Problem& problem, const Segment& segment, std::uint8_t conditions, bool is_wall,
                 NodeConditions& result, Masters& masters)
{
    const int axis = normal_axis(segment);
    for_each_node_held(problem, segment, segment, [&](std::size_t node) {
        if (axis < 0) {
            result.slanted.push_back({node, outward_normal(segment), conditions});
        } else {
            result.of_node[node] |= axis == 0 ? conditions : turned(conditions);
        }
    });
    if (is_wall && axis >= 0) tie_beyond(problem, segment, segment, masters);
}

/// The nodes on either side of a moving wall; those of a slanted wall as of one that stands.
void add_moving_segment(const Problem& problem, std::size_t boundary, std::size_t segment, double time,
                        NodeConditions& result, Masters& masters)
{
    const BackgroundGrid& grid = problem.grid;
    const Boundary& wall = problem.boundaries[boundary];
    const Segment& drawn = wall.segments[segment];
    const Vector2 moved = wall_displacement(*wall.motion, drawn, time);
    const Segment present{drawn.start + moved, drawn.end + moved};
    const int axis = normal_axis(drawn);
    const int row = axis < 0 ? 0 : first_row_beyond(grid, present, axis);
    const auto columns = static_cast<std::size_t>(grid.nodes_x());
    WallNode pair;
    pair.boundary = boundary;
    pair.segment = segment;
    pair.normal = outward_normal(drawn);
    if (axis >= 0) pair.normal = pair.normal.array().round().matrix();
    pair.grip = wall.motion->grip;
    pair.sealed = wall.water == WaterCondition::impervious;
    for_each_node_held(problem, drawn, present, [&](std::size_t node) {
        pair.inner = pair.outer = node;
        if (axis >= 0) {
            if (static_cast<int>(axis == 0 ? node % columns : node / columns) != row) return;
            const std::size_t step = axis == 0 ? 1 : columns;
            pair.inner = pair.normal[axis] > 0.0 ? node - step : node + step;
            pair.outer_share = share_of_outer(grid, pair, present.start);
        }
        result.walls.push_back(pair);
    });
    if (axis >= 0) tie_beyond(problem, drawn, present, masters);
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

NodeConditions node_conditions(const Problem& problem, Stage stage, double time)
{
    NodeConditions result;
    result.of_node.assign(problem.grid.node_count(), 0);
    Masters masters(problem.grid.node_count());
    std::iota(masters.begin(), masters.end(), std::size_t{0});
    for (std::size_t b = 0; b < problem.boundaries.size(); ++b) {
        const Boundary& boundary = problem.boundaries[b];
        for (std::size_t s = 0; s < boundary.segments.size(); ++s) {
            const Segment& segment = boundary.segments[s];
            if (boundary.soil == SoilCondition::moving) {
                add_moving_segment(problem, b, s, time, result, masters);
                continue;
            }
            const SoilCondition soil = condition_in(stage, boundary, segment);
            const std::uint8_t conditions = conditions_of(soil, boundary.water);
            const bool is_wall = soil == SoilCondition::fixed || soil == SoilCondition::roller ||
                                 soil == SoilCondition::viscous;
            if (conditions != 0 || is_wall)
                add_segment(problem, segment, conditions, is_wall, result, masters);
        }
    }
    merge_corners(result);
    if (problem.tied_sides) tie_sides(problem, masters);
    result.tied = resolve(masters);
    result.master = std::move(masters);
    // tied nodes follow their masters, which the wall holds too
    std::erase_if(result.walls,
                  [&](const WallNode& wall) { return result.master[wall.outer] != wall.outer; });
    return result;
}

} // namespace quicksand
