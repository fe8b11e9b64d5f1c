// What the columns of free-field sides take from the body, and why there may be none.
#include "solver/free_field/free_field_columns.hpp"
#include "solver/free_field/wave_steps.hpp"
#include "tests/fixtures/free_field_ground.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

Problem ground(std::optional<WaterFlow> flow = {})
{
    return layered_ground(FreeFieldSide{}, flow);
}

State state_of(Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 6.0; });
    attach_boundaries(problem, state.particles);
    return state;
}

/// What is in the way at the left side, the right one being level.
std::string left_obstacle(Problem problem, State state)
{
    const auto found = add_free_fields(problem, state);
    if (found.empty()) return "";
    EXPECT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().boundary, "left");
    return found.front().what;
}

TEST(FreeFieldColumns, HaveTheSoilBesideTheirSides)
{
    Problem problem = ground();
    problem.boundaries[0].soil = ViscousFace{};
    State state = state_of(problem);
    ASSERT_TRUE(add_free_fields(problem, state).empty());
    ASSERT_EQ(problem.free_fields.size(), 2U);
    const FreeField& left = problem.free_fields[1];
    EXPECT_EQ(left.x, 0.0);
    EXPECT_EQ(left.outward, -1.0);
    EXPECT_EQ(left.column.grid.cells_x, 1);
    EXPECT_EQ(left.column.grid.origin.x(), 0.0);
    EXPECT_EQ(problem.free_fields[0].column.grid.origin.x(), 11.5);
    EXPECT_EQ(left.column.tied_sides->period, left.column.grid.cell_size);
    ASSERT_EQ(left.column.boundaries.size(), 4U); // base, top, both sides
    EXPECT_EQ(left.column.boundaries[0].pieces.size(), 2U);
    const Particles& particles = state.free_fields[1].column.particles;
    ASSERT_EQ(particles.size(), 48U);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        EXPECT_EQ(particles.identifier[p], static_cast<std::int32_t>(p));
        EXPECT_LT(particles.position.x[p], 0.5);
    }
}

// A stage that shakes is told its step before its columns have moved.
TEST(FreeFieldColumns, BearNoPartOfTheMotionThatBoundsTheStep)
{
    Problem problem = ground(WaterFlow::coupled);
    problem.boundaries[0].soil = ViscousFace{};
    State state = state_of(problem);
    ASSERT_TRUE(add_free_fields(problem, state).empty());
    const double settling = first_time_step(problem, state).dt;
    state.stage = Stage::shaking;
    EXPECT_EQ(first_time_step(problem, state).dt, settling);
}

TEST(FreeFieldColumns, OneStandsForAllCurvesAtAPlace)
{
    Problem problem = ground();
    Boundary upper = problem.boundaries[3];
    upper.name = "upper left";
    upper.segments = {{{0.0, 6.0}, {0.0, 2.0}}};
    problem.boundaries[3].segments = {{{0.0, 2.0}, {0.0, 0.0}}};
    problem.boundaries.push_back(upper);
    State state = state_of(problem);
    EXPECT_TRUE(add_free_fields(problem, state).empty());
    EXPECT_EQ(problem.free_fields.size(), 2U);
}

TEST(FreeFieldColumns, NeedLevelGround)
{
    Problem problem = ground(WaterFlow::coupled);
    State state = state_of(problem);
    EXPECT_EQ(left_obstacle(problem, state), "");

    State layers = state;
    layers.particles.material[0] = 1;
    EXPECT_EQ(left_obstacle(problem, layers), "its layers are not level beside it");

    State water = state;
    water.particles.pore_pressure[0] = 2000.0; // by a fifth of a cell higher
    EXPECT_EQ(left_obstacle(problem, water), "the water beside it is not level");

    const std::string uneven = "the ground beside it is not level over the first column of cells";
    State stress = state;
    stress.particles.stress.yy[0] = 2000.0;
    EXPECT_EQ(left_obstacle(problem, stress), uneven);

    Problem slope = problem;
    slope.boundaries[2].segments = {{{12.0, 6.0}, {1.0, 6.0}}, {{1.0, 6.0}, {0.0, 5.9}}};
    EXPECT_EQ(left_obstacle(slope, state),
              "the curve \"" + slope.boundaries[2].name + "\" is not level over the first column of cells");
}

TEST(FreeFieldColumns, HaveTheWaterNearestToTheSide)
{
    Problem problem = ground(WaterFlow::coupled);
    State state = state_of(problem);
    Particles& body = state.particles;
    for (std::size_t p = 0; p < body.size(); ++p) body.pore_pressure[p] = 500.0 * body.position.x[p];
    EXPECT_EQ(left_obstacle(problem, state), "");
    add_free_fields(problem, state);
    for (const FreeFieldState& field : state.free_fields) {
        const Particles& column = field.column.particles;
        const auto [least, most] =
            std::minmax_element(column.pore_pressure.begin(), column.pore_pressure.end());
        EXPECT_EQ(*least, *most);
    }
    const double left = state.free_fields[0].column.particles.pore_pressure[0],
                 right = state.free_fields[1].column.particles.pore_pressure[0];
    EXPECT_NEAR(std::abs(left - right), 500.0 * (12.0 - 2.0 * 0.125), 1e-9); // a quarter of a cell inside
}

TEST(FreeFieldColumns, NeedPointsInColumnsOfCells)
{
    Problem problem = ground();
    State state = state_of(problem);
    state.particles.position.x[0] += 0.3; // over the next line of the grid
    EXPECT_EQ(left_obstacle(problem, state),
              "the material points beside it do not fill the first column of cells");
}

TEST(FreeFieldColumns, NeedSidesFromTheBaseToTheSurface)
{
    Problem problem = ground();
    problem.boundaries[3].segments = {{{0.0, 6.0}, {0.0, 2.0}}};
    const State state = state_of(problem);
    EXPECT_EQ(left_obstacle(problem, state),
              "it does not bound all of the soil beside it, from the base to the surface");
}

TEST(FreeFieldColumns, HaveNoMovingCurves)
{
    Problem problem = ground();
    problem.boundaries[2].soil = MovingWall{};
    problem.boundaries[2].segments = {{{12.0, 6.0}, {6.0, 6.0}}, {{6.0, 6.0}, {0.0, 6.0}}};
    problem.boundaries[1].soil = RollerWall{};
    const State state = state_of(problem);
    EXPECT_EQ(left_obstacle(problem, state), "the curve \"top\" moves beside it");
}

} // namespace
} // namespace quicksand
