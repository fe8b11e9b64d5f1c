// Walls that move: curves whose grains have a given velocity or displacement.
//
// A wall that is parallel to the grid and lies between two rows of nodes holds the velocity that the grid has
// at the wall's own place, not that of the next row: of the pair of nodes on either side,
//   (1 - f) v_inner + f v_outer = V,   f the wall's distance from the inner node in cells,
// by one impulse that the two share as (1 - f) and f. As the wall passes a row of nodes the condition goes
// over to the next pair without a jump. A slanted wall acts at the first nodes beyond it.
#pragma once

#include "solver/boundary_conditions.hpp"
#include "solver/node_response.hpp"
#include "solver/nodes.hpp"
#include "solver/problem.hpp"
#include "solver/state.hpp"

#include <algorithm>
#include <vector>

namespace quicksand {

/// How far a segment of a moving curve has come since t = 0 [m].
Vector2 wall_displacement(const WallMotion& motion, const Segment& segment, double time);

/// Mean velocity of a segment over a step from `time` on; at its end the wall is where it has to be [m/s].
Vector2 wall_velocity(const WallMotion& motion, const Segment& segment, double time, double dt);

/// The distance of a wall through `place` from the inner node of a pair across it, at most a cell [cells].
double share_of_outer(const BackgroundGrid& grid, const WallNode& wall, const Vector2& place);

/// Bring the conditions up to the walls' places at the state's time and their velocities over the step. While
/// the soil settles the walls stand still. Returns whether the nodes concerned have changed.
bool move_walls(const Problem& problem, const State& state, double dt, NodeConditions& conditions);

/// Give the nodes the walls' velocities, after the momentum balance. The water of a sealed wall moves with
/// its normal velocity.
void hold_at_walls(const Problem& problem, const NodeConditions& conditions, double dt,
                   const std::vector<TwoPhaseSums>& sums, std::vector<TwoPhaseMotion>& motion);
void hold_at_walls(const NodeConditions& conditions, double dt, const std::vector<SinglePhaseSums>& sums,
                   std::vector<SinglePhaseMotion>& motion);

/// A pair of nodes that a wall holds in one direction.
struct HeldPair {
    NodeResponse inner, outer;
    Vector2 direction = Vector2::Zero(); // [-]
    double outer_share = 0.0;            // f [-]
    bool sealed = false;                 // the water is held as well

    /// Velocity at the wall per impulse there.
    NodeResponse at_wall() const
    {
        const double a = (1.0 - outer_share) * (1.0 - outer_share), b = outer_share * outer_share;
        return {a * inner.solid + b * outer.solid, a * inner.exchange + b * outer.exchange,
                a * inner.fluid + b * outer.fluid};
    }
};

/// Impulses on grains and water at the wall [N s/m].
struct WallImpulse {
    double solid = 0.0, fluid = 0.0;
};

/// The impulses that add the velocities missing at the wall; only on the grains where the water is free.
WallImpulse wall_impulse(const NodeResponse& wall, bool sealed, double missing_solid, double missing_fluid);

/// Call hold(wall, pair) for the directions that walls hold at nodes with soil.
template <class Sums, class Hold>
void for_each_held_pair(const NodeConditions& conditions, double dt, const std::vector<Sums>& sums,
                        Hold&& hold);

/// Response of a node in any direction; where that is none of the axes, both of them have to be free.
template <class Sums>
NodeResponse response_along(const Sums& node, double dt, std::uint8_t held, const Vector2& direction)
{
    const NodeResponse x = response(node, dt, held, 0), y = response(node, dt, held, 1);
    if (direction.y() == 0.0) return x;
    if (direction.x() == 0.0) return y;
    return {std::min(x.solid, y.solid), std::min(x.exchange, y.exchange), std::min(x.fluid, y.fluid)};
}

template <class Sums, class Hold>
void for_each_held_pair(const NodeConditions& conditions, double dt, const std::vector<Sums>& sums,
                        Hold&& hold)
{
    for (const WallNode& wall : conditions.walls) {
        const Sums &inner = sums[wall.inner], &outer = sums[wall.outer];
        if (!inner.active() && !outer.active()) continue;
        const double share = !inner.active() ? 1.0 : outer.active() ? wall.outer_share : 0.0;
        const auto pair_along = [&](const Vector2& direction, bool sealed) {
            return HeldPair{response_along(inner, dt, conditions.of_node[wall.inner], direction),
                            response_along(outer, dt, conditions.of_node[wall.outer], direction), direction,
                            share, sealed};
        };
        hold(wall, pair_along(wall.normal, wall.sealed));
        const Vector2 across(-wall.normal.y(), wall.normal.x());
        if (wall.grip == WallGrip::rough) hold(wall, pair_along(across, false));
    }
}

} // namespace quicksand
