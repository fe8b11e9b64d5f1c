#include "solver/moving_walls.hpp"

#include "solver/grid_momentum.hpp"
#include "solver/node_response.hpp"
#include "solver/wall_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// The wall's value: its velocity or displacement at a factor of 1.
Vector2 full_motion(const WallMotion& motion, const Segment& segment)
{
    if (motion.grip == WallGrip::rough) return motion.value;
    return -motion.inward * outward_normal(segment);
}

template <class Motion>
void push(Motion& motion, const NodeResponse& response, double share, const WallImpulse& impulse,
          const Vector2& direction)
{
    add_velocity(motion,
                 share * (response.solid * impulse.solid + response.exchange * impulse.fluid) * direction,
                 share * (response.exchange * impulse.solid + response.fluid * impulse.fluid) * direction);
}

template <class Sums, class Motion>
void hold_all(const NodeConditions& conditions, double dt, const std::vector<Sums>& sums,
              std::vector<Motion>& motion)
{
    for_each_held_pair(conditions, dt, sums, [&](const WallNode& wall, const HeldPair& pair) {
        Motion &inner = motion[wall.inner], &outer = motion[wall.outer];
        const auto missing = [&](const Vector2& at_inner, const Vector2& at_outer) {
            const Vector2 at_wall = (1.0 - pair.outer_share) * at_inner + pair.outer_share * at_outer;
            return (wall.velocity - at_wall).dot(pair.direction);
        };
        const WallImpulse impulse =
            wall_impulse(pair.at_wall(), pair.sealed, missing(solid_velocity(inner), solid_velocity(outer)),
                         missing(fluid_velocity(inner), fluid_velocity(outer)));
        push(inner, pair.inner, 1.0 - pair.outer_share, impulse, pair.direction);
        push(outer, pair.outer, pair.outer_share, impulse, pair.direction);
    });
}

/// Where the conditions of moving walls change: rows of nodes for walls parallel to the grid, parts of a cell
/// for slanted ones, whose nodes are those of the time when a part was entered.
std::vector<std::int64_t> rows_of_walls(const Problem& problem, double time)
{
    constexpr double parts_of_cell = 64.0;
    std::vector<std::int64_t> rows;
    for (const Boundary& boundary : problem.boundaries) {
        if (boundary.soil != SoilCondition::moving) continue;
        for (const Segment& drawn : boundary.segments) {
            const Vector2 moved = wall_displacement(*boundary.motion, drawn, time);
            const int axis = normal_axis(drawn);
            const Segment wall{drawn.start + moved, drawn.end + moved};
            const Vector2 parts = moved / problem.grid.cell_size * parts_of_cell;
            for (const int direction : {0, 1}) {
                rows.push_back(direction == axis ? first_row_beyond(problem.grid, wall, axis)
                                                 : std::llround(parts[direction]));
            }
        }
    }
    return rows;
}

} // namespace

Vector2 wall_displacement(const WallMotion& motion, const Segment& segment, double time)
{
    const double factor = motion.quantity == MotionQuantity::velocity
                              ? history_integral(motion.history, time)
                              : history_value(motion.history, time) - history_value(motion.history, 0.0);
    return factor * full_motion(motion, segment);
}

Vector2 wall_velocity(const WallMotion& motion, const Segment& segment, double time, double dt)
{
    return (wall_displacement(motion, segment, time + dt) - wall_displacement(motion, segment, time)) / dt;
}

double share_of_outer(const BackgroundGrid& grid, const WallNode& wall, const Vector2& place)
{
    const double beyond = (grid.node_position(wall.outer) - place).dot(wall.normal) / grid.cell_size;
    return 1.0 - std::clamp(beyond, 0.0, 1.0);
}

bool move_walls(const Problem& problem, const State& state, double dt, NodeConditions& conditions)
{
    if (conditions.walls.empty()) return false;
    const bool shaking = state.stage == Stage::shaking;
    const double time = shaking ? state.time : 0.0;
    // in small strain the equations are those of the reference shape, which has the wall where it was drawn
    const double time_of_place = problem.strain == StrainForm::small ? 0.0 : time;
    std::vector<std::int64_t> rows = rows_of_walls(problem, time_of_place);
    const bool changed = rows != conditions.wall_rows;
    if (changed) {
        conditions = node_conditions(problem, state.stage, time_of_place);
        conditions.wall_rows = std::move(rows);
    }
    const BackgroundGrid& grid = problem.grid;
    for (WallNode& node : conditions.walls) {
        const Boundary& boundary = problem.boundaries[node.boundary];
        const Segment& drawn = boundary.segments[node.segment];
        node.velocity = shaking ? wall_velocity(*boundary.motion, drawn, time, dt) : Vector2(0.0, 0.0);
        if (node.inner == node.outer) continue;
        const Vector2 place = drawn.start + wall_displacement(*boundary.motion, drawn, time_of_place);
        node.outer_share = share_of_outer(grid, node, place);
    }
    return changed;
}

void hold_at_walls(const Problem& problem, const NodeConditions& conditions, double dt,
                   const std::vector<TwoPhaseSums>& sums, std::vector<TwoPhaseMotion>& motion)
{
    hold_all(conditions, dt, sums, motion);
    for (const WallNode& wall : conditions.walls) {
        for (const std::size_t i : {wall.inner, wall.outer}) {
            if (sums[i].active()) set_flux(problem, sums[i], motion[i]);
        }
    }
}

void hold_at_walls(const NodeConditions& conditions, double dt, const std::vector<SinglePhaseSums>& sums,
                   std::vector<SinglePhaseMotion>& motion)
{
    hold_all(conditions, dt, sums, motion);
}

WallImpulse wall_impulse(const NodeResponse& wall, bool sealed, double missing_solid, double missing_fluid)
{
    if (wall.solid <= 0.0) return {0.0, sealed && wall.fluid > 0.0 ? missing_fluid / wall.fluid : 0.0};
    if (!sealed || wall.fluid <= 0.0) return {missing_solid / wall.solid, 0.0};
    const double determinant = wall.solid * wall.fluid - wall.exchange * wall.exchange;
    constexpr double singular = 1e-12; // grains and water move together already
    if (determinant <= singular * wall.solid * wall.fluid) return {missing_solid / wall.solid, 0.0};
    return {(wall.fluid * missing_solid - wall.exchange * missing_fluid) / determinant,
            (wall.solid * missing_fluid - wall.exchange * missing_solid) / determinant};
}

} // namespace quicksand
