// What implicit steps cost, by the parts of a step.
#include "solver/step/implicit_cost.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// Sand of 12 m x 4 m in a box with its lower left corner at (a, a), on cells of 1 m.
StepParts parts_of_box(double a, bool saturated, int per_cell = 2)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 14, 6};
    problem.materials = {stiff_sand()};
    problem.scheme = TimeScheme::implicit;
    if (saturated) problem.water = water_to(a + 4.0);
    problem.boundaries = rectangle(a, a, a + 12.0, a + 4.0, FixedWall{}, RollerWall{}, FreeFace{});
    Problem lattice = problem;
    lattice.grid.origin = {a, a};
    const State state = fill(lattice, per_cell, [&](const Vector2& x) {
        return x.x() > a && x.x() < a + 12.0 && x.y() > a && x.y() < a + 4.0;
    });
    return count_parts(problem, state);
}

TEST(ImplicitCost, CountsThePartsOfAStep)
{
    for (const bool saturated : {false, true}) {
        const StepParts on_lines = parts_of_box(1.0, saturated);
        EXPECT_EQ(on_lines.particles, 4.0 * 12.0 * 4.0);
        EXPECT_EQ(on_lines.nodes, 13.0 * 5.0);
        EXPECT_EQ(on_lines.height, 5.0);
        EXPECT_EQ(on_lines.rows, 0.0);
        EXPECT_FALSE(on_lines.rows_repeat);
        const StepParts between = parts_of_box(1.3, saturated);
        EXPECT_EQ(between.particles, on_lines.particles);
        EXPECT_EQ(between.nodes, 14.0 * 6.0);
        EXPECT_EQ(between.height, 6.0);
        EXPECT_GT(between.rows, 2.0 * (12.0 + 4.0)); // of the grains alone: base and one of the sides
        EXPECT_TRUE(between.rows_repeat) << "in the corners of the base";
    }
}

TEST(ImplicitCost, GrowsWithTheNodesOfAParticleAndWithCornersBetweenGridLines)
{
    const double two = implicit_cost(parts_of_box(1.0, true, 2)),
                 four = implicit_cost(parts_of_box(1.0, true, 4)),
                 between = implicit_cost(parts_of_box(1.3, true, 2));
    EXPECT_GT(two, 1.1 * four);
    EXPECT_GT(between, 1.3 * two);
    EXPECT_GT(four, 1.5);
    EXPECT_LT(between, 6.0);
    // measured: 2.16 in the sea dike under 100 g, 2.77 in a column of one particle a row
    EXPECT_NEAR(implicit_cost({14692.0, 1884.0, 36.0, 208.0, false}), 2.16, 0.3);
    EXPECT_NEAR(implicit_cost({240.0, 162.0, 2.0, 0.0, false}), 2.77, 0.3);
}

} // namespace
} // namespace quicksand
