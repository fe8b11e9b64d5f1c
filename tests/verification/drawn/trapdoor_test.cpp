// A door in the base under dry sand that moves down: the sand arches over it, and presses on it with less
// than its weight wherever the lines of the grid lie.
#include "solver/measure/balances.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double door_width = 2.0, sand_depth = 3.0; // of the door and of the sand [m]
constexpr double friction_tangent = 0.57735;         // of 30 degrees
constexpr double unit_weight = 0.6 * 2650 * 9.81;    // [N/m3]

AssembledCase sand_over_door(const Vector2& origin)
{
    const std::string text = R"(scene_version = 1
[geometry]
file = "drawing.geo"
[analysis]
scheme = "implicit"
[grid]
cell_size = 0.25
cells = [36, 18]
origin = [)" + std::to_string(origin.x()) +
                             ", " + std::to_string(origin.y()) + R"(]
[materials.sand]
model = "mohr_coulomb"
shear_modulus = 1e7
poisson_ratio = 0.3
friction_angle = 30
cohesion = 0
porosity = 0.4
grain_density = 2650
[regions.soil]
material = "sand"
[boundaries.left_base]
soil = "fixed"
[boundaries.right_base]
soil = "fixed"
[boundaries.left]
soil = "roller"
[boundaries.right]
soil = "roller"
[boundaries.door]
soil = "moving"
normal_velocity = -0.01
ramp_time = 0.3
[run]
end_time = 1.4
)";
    return assemble(text, polygon_section({{{0.0, 0.0}, "left_base"},
                                           {{3.0, 0.0}, "door"},
                                           {{5.0, 0.0}, "right_base"},
                                           {{8.0, 0.0}, "right"},
                                           {{8.0, sand_depth}, "top"},
                                           {{0.0, sand_depth}, "left"}}));
}

/// With which the sand presses on the door that moves [N/m].
double force_on_door(const Vector2& origin)
{
    AssembledCase assembled = sand_over_door(origin);
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    open_balances(assembled.problem, state);
    run(assembled.problem, 0.9, {}, state);
    const double before = state.balance_terms->boundary_work, start = state.time;
    run(assembled.problem, 1.4, {}, state);
    const double moved = 0.01 * (state.time - start); // after the ramp
    return -(state.balance_terms->boundary_work - before) / moved;
}

// Terzaghi (1943), with K = 1: B gamma (1 - exp(-2 K tan phi H/B)) / (2 K tan phi) on each m2 of the door.
// Rows that hold the mean of a cell's nodes let those beside the door's ends move to and fro: the door pulled
// at the sand by 13 to 1,040 kN/m.
TEST(Trapdoor, IsPressedByLessThanTheWeightOfTheSandWhereverTheGridLies)
{
    const double arching = 2.0 * friction_tangent;
    const double expected = door_width * door_width * unit_weight / arching *
                            (1.0 - std::exp(-arching * sand_depth / door_width));
    for (const Vector2& origin : {Vector2(-0.5, -0.5), Vector2(-0.5, -0.63), Vector2(-0.6, -0.5),
                                  Vector2(-0.62, -0.57), Vector2(-0.55, -0.70)}) {
        const double force = force_on_door(origin) / expected; // measured 0.70 to 0.96
        EXPECT_GT(force, 0.6) << origin.transpose();
        EXPECT_LT(force, 1.1) << origin.transpose();
    }
}

} // namespace
} // namespace quicksand
