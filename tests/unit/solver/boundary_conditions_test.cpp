#include "solver/boundary_conditions.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// A box of 4 x 3 m on a grid of 1 m cells with a margin of one cell on every side.
Problem box(SoilCondition base, SoilCondition sides)
{
    Problem problem;
    problem.grid = {{-1.0, -1.0}, 1.0, 6, 5};
    problem.materials = {stiff_sand()};
    problem.water = water_to(3.0);
    problem.boundaries = rectangle(0.0, 0.0, 4.0, 3.0, base, sides, SoilCondition::free);
    return problem;
}

std::uint8_t conditions_at(const Problem& problem, const NodeConditions& conditions, double x, double y)
{
    const Vector2 cells = (Vector2(x, y) - problem.grid.rim_origin()) / problem.grid.cell_size;
    return conditions.of_node[static_cast<std::size_t>(std::lround(cells.y()) * problem.grid.nodes_x() +
                                                       std::lround(cells.x()))];
}

TEST(BoundaryConditions, WallsHoldTheNodesOnAndBeyondThem)
{
    const Problem problem = box(SoilCondition::fixed, SoilCondition::roller);
    const NodeConditions conditions = node_conditions(problem);
    const std::uint8_t base = solid_x_fixed | solid_y_fixed | fluid_y_fixed,
                       side = solid_x_fixed | fluid_x_fixed;
    EXPECT_EQ(conditions_at(problem, conditions, 2.0, 0.0), base);
    EXPECT_EQ(conditions_at(problem, conditions, 2.0, -2.0), base);
    EXPECT_EQ(conditions_at(problem, conditions, 0.0, 2.0), side);
    EXPECT_EQ(conditions_at(problem, conditions, -1.0, 2.0), side);
    EXPECT_EQ(conditions_at(problem, conditions, 0.0, 0.0), base | side);
    EXPECT_EQ(conditions_at(problem, conditions, 2.0, 2.0), 0);
    EXPECT_EQ(conditions_at(problem, conditions, 2.0, 3.0), 0);
}

TEST(BoundaryConditions, AWallGoesOnBeyondAConvexCornerOfTheSoil)
{
    const Problem problem = box(SoilCondition::fixed, SoilCondition::roller);
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_TRUE(conditions_at(problem, conditions, 4.0, 4.0) &
                solid_x_fixed); // above the soil, along the side
}

TEST(BoundaryConditions, AWallEndsWhereItsNeighbourGoesStraightOn)
{
    Problem problem = box(SoilCondition::fixed, SoilCondition::roller);
    problem.boundaries[0].segments = {{{0.0, 0.0}, {2.0, 0.0}}};
    problem.boundaries.push_back(
        {"rail", SoilCondition::roller, WaterCondition::impervious, {{{2.0, 0.0}, {4.0, 0.0}}}});
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_TRUE(conditions_at(problem, conditions, 1.0, 0.0) & solid_x_fixed);
    EXPECT_FALSE(conditions_at(problem, conditions, 3.0, 0.0) & solid_x_fixed);
    EXPECT_TRUE(conditions_at(problem, conditions, 3.0, 0.0) & solid_y_fixed);
}

TEST(BoundaryConditions, ASlantedRollerHoldsItsNormalDirection)
{
    Problem problem = box(SoilCondition::free, SoilCondition::free);
    problem.boundaries[1].segments = {{{4.0, 0.0}, {3.0, 3.0}}};
    problem.boundaries[1].soil = SoilCondition::roller;
    const NodeConditions conditions = node_conditions(problem);
    ASSERT_FALSE(conditions.slanted.empty());
    EXPECT_NEAR(conditions.slanted[0].normal.dot(Vector2(-1.0, 3.0)), 0.0, 1e-15);
    EXPECT_GT(conditions.slanted[0].normal.x(), 0.0); // out of the soil
}

/// The node that carries the sums of the node at (x, y).
Vector2 master_of(const Problem& problem, const NodeConditions& conditions, double x, double y)
{
    for (const TiedNodes& tie : conditions.tied) {
        if ((problem.grid.node_position(tie.node) - Vector2(x, y)).norm() < 1e-9)
            return problem.grid.node_position(tie.master);
    }
    return {x, y};
}

TEST(BoundaryConditions, NodesBeyondAWallAreTiedToIt)
{
    const Problem problem = box(SoilCondition::fixed, SoilCondition::roller);
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_EQ(master_of(problem, conditions, 2.0, -2.0), Vector2(2.0, 0.0));
    EXPECT_EQ(master_of(problem, conditions, -1.0, 2.0), Vector2(0.0, 2.0));
    EXPECT_EQ(master_of(problem, conditions, 6.0, -3.0), Vector2(4.0, 0.0));
    EXPECT_EQ(master_of(problem, conditions, 2.0, 3.0), Vector2(2.0, 3.0));
}

TEST(BoundaryConditions, AWallBetweenGridLinesActsAtTheFirstNodesBeyondIt)
{
    Problem problem = box(SoilCondition::fixed, SoilCondition::roller);
    problem.boundaries =
        rectangle(0.0, 0.0, 3.6, 3.0, SoilCondition::fixed, SoilCondition::roller, SoilCondition::free);
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_FALSE(conditions_at(problem, conditions, 3.0, 2.0) & solid_x_fixed);
    EXPECT_TRUE(conditions_at(problem, conditions, 4.0, 2.0) & solid_x_fixed);
    EXPECT_EQ(master_of(problem, conditions, 5.0, 2.0), Vector2(4.0, 2.0));
}

TEST(BoundaryConditions, TiedSidesMakeColumnsPeriodic)
{
    Problem problem = box(SoilCondition::fixed, SoilCondition::tied);
    problem.tied_sides = TiedSides{"left", "right", 0.0, 4.0};
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_EQ(master_of(problem, conditions, 4.0, 2.0), Vector2(0.0, 2.0));
    EXPECT_EQ(master_of(problem, conditions, -1.0, 2.0), Vector2(3.0, 2.0));
    EXPECT_EQ(master_of(problem, conditions, 5.0, 0.0), Vector2(1.0, 0.0));
    EXPECT_EQ(master_of(problem, conditions, -1.0, -2.0), Vector2(3.0, 0.0)); // below the base as well
    EXPECT_EQ(master_of(problem, conditions, 2.0, 2.0), Vector2(2.0, 2.0));
}

} // namespace
} // namespace quicksand
