#include "solver/boundaries/boundary_conditions.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
    problem.boundaries = rectangle(0.0, 0.0, 4.0, 3.0, base, sides, FreeFace{});
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
    const Problem problem = box(FixedWall{}, RollerWall{});
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
    const Problem problem = box(FixedWall{}, RollerWall{});
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_TRUE(conditions_at(problem, conditions, 4.0, 4.0) &
                solid_x_fixed); // above the soil, along the side
}

TEST(BoundaryConditions, AWallEndsWhereItsNeighbourGoesStraightOn)
{
    Problem problem = box(FixedWall{}, RollerWall{});
    problem.boundaries[0].segments = {{{0.0, 0.0}, {2.0, 0.0}}};
    problem.boundaries.push_back({"rail", RollerWall{}, Impervious{}, {{{2.0, 0.0}, {4.0, 0.0}}}});
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_TRUE(conditions_at(problem, conditions, 1.0, 0.0) & solid_x_fixed);
    EXPECT_FALSE(conditions_at(problem, conditions, 3.0, 0.0) & solid_x_fixed);
    EXPECT_TRUE(conditions_at(problem, conditions, 3.0, 0.0) & solid_y_fixed);
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
    const Problem problem = box(FixedWall{}, RollerWall{});
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_EQ(master_of(problem, conditions, 2.0, -2.0), Vector2(2.0, 0.0));
    EXPECT_EQ(master_of(problem, conditions, -1.0, 2.0), Vector2(0.0, 2.0));
    EXPECT_EQ(master_of(problem, conditions, 6.0, -3.0), Vector2(4.0, 0.0));
    EXPECT_EQ(master_of(problem, conditions, 2.0, 3.0), Vector2(2.0, 3.0));
}

/// Soil of 12 x 12 m around a hole of `width` m, whose lower left corner is at (5, 5).
Problem soil_around_hole(double width, SoilCondition walls)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 12, 12};
    problem.materials = {stiff_sand()};
    problem.water = water_to(12.0);
    problem.boundaries = rectangle(0.0, 0.0, 12.0, 12.0, FreeFace{}, FreeFace{}, {});
    const double lower = 5.0, upper = lower + width;
    const Vector2 a(lower, lower), b(lower, upper), c(upper, upper), d(upper, lower);
    problem.boundaries.push_back({"hole", walls, Impervious{}, {{a, b}, {b, c}, {c, d}, {d, a}}});
    return problem;
}

TEST(BoundaryConditions, WallsThatFaceEachOtherLeaveTheSoilBeyondFree)
{
    for (const double width : {1.0, 2.0, 3.0}) {
        const Problem problem = soil_around_hole(width, FixedWall{});
        const NodeConditions conditions = node_conditions(problem);
        const auto at = [&](double x, double y) { return conditions_at(problem, conditions, x, y); };
        const double far = 5.0 + width, middle = 5.0 + std::floor(0.5 * width);
        for (const double wall : {5.0, far}) {
            EXPECT_TRUE(at(wall, middle) & solid_x_fixed) << width;
            EXPECT_TRUE(at(middle, wall) & solid_y_fixed) << width;
        }
        for (const double soil : {4.0, far + 1.0, far + 2.0}) {
            EXPECT_EQ(at(soil, middle), 0) << width << ' ' << soil;
            EXPECT_EQ(at(middle, soil), 0) << width << ' ' << soil;
        }
        for (const TiedNodes& tie : conditions.tied) {
            const Vector2 node = problem.grid.node_position(tie.node);
            EXPECT_TRUE((node.array() > 5.0).all() && (node.array() < far).all()) << width << ' ' << node;
        }
    }
}

TEST(BoundaryConditions, AWallLeavesTheNodesOfItsNeighbourAtAReentrantCorner)
{
    const Problem problem = soil_around_hole(3.0, RollerWall{});
    const NodeConditions conditions = node_conditions(problem);
    const auto at = [&](double x, double y) { return conditions_at(problem, conditions, x, y); };
    const std::uint8_t sides = solid_x_fixed | fluid_x_fixed, levels = solid_y_fixed | fluid_y_fixed;
    EXPECT_EQ(at(6.0, 5.0), levels);
    EXPECT_EQ(at(7.0, 8.0), levels);
    EXPECT_EQ(at(5.0, 6.0), sides);
    EXPECT_EQ(at(8.0, 7.0), sides);
    EXPECT_EQ(at(5.0, 5.0), sides | levels);
}

TEST(BoundaryConditions, AWallEndsAtAnEdgeThatHasNoName)
{
    // soil of two levels: the roller of the upper one's right side does not go down through the lower one
    Problem problem = box(FreeFace{}, FreeFace{});
    const Vector2 foot(2.0, 1.0), top(2.0, 3.0);
    problem.boundaries = {{"cut", RollerWall{}, Impervious{}, {{foot, top}}}};
    EXPECT_TRUE(conditions_at(problem, node_conditions(problem), 2.0, 0.0) & solid_x_fixed);
    problem.rim = {{{0.0, 0.0}, {4.0, 0.0}}, {{4.0, 0.0}, {4.0, 1.0}}, {{4.0, 1.0}, foot}, {foot, top},
                   {top, {0.0, 3.0}},        {{0.0, 3.0}, {0.0, 0.0}}};
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_FALSE(conditions_at(problem, conditions, 2.0, 0.0) & solid_x_fixed);
    EXPECT_TRUE(conditions_at(problem, conditions, 2.0, 2.0) & solid_x_fixed);
    EXPECT_TRUE(conditions_at(problem, conditions, 2.0, 4.0) & solid_x_fixed);
}

TEST(BoundaryConditions, AWallDoesNotGoOnIntoOtherSoil)
{
    // the base of a body of 0 to 1 m goes on to the right only as far as the deeper body from 3 to 5 m
    Problem problem = box(FreeFace{}, FreeFace{});
    problem.boundaries = rectangle(0.0, 0.0, 1.0, 2.0, FixedWall{}, FreeFace{}, {});
    for (Boundary& edge : rectangle(3.0, -1.0, 5.0, 2.0, FreeFace{}, FreeFace{}, {}))
        problem.boundaries.push_back(edge);
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_TRUE(conditions_at(problem, conditions, 2.0, 0.0) & solid_y_fixed);
    EXPECT_FALSE(conditions_at(problem, conditions, 4.0, 0.0) & solid_y_fixed);
    EXPECT_FALSE(conditions_at(problem, conditions, 4.0, -1.0) & solid_y_fixed);
}

TEST(BoundaryConditions, WallsOffTheGridLinesHoldNoNodes)
{
    Problem problem = box(FreeFace{}, FreeFace{});
    problem.boundaries = rectangle(0.0, 0.0, 3.6, 3.0, FreeFace{}, RollerWall{}, FreeFace{});
    problem.boundaries[0].soil = FixedWall{};
    problem.boundaries[0].segments = {{{0.0, 0.0}, {3.6, 0.4}}};
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_EQ(conditions_at(problem, conditions, 4.0, 2.0), 0);
    EXPECT_EQ(conditions_at(problem, conditions, 2.0, 0.0), 0);
    EXPECT_TRUE(conditions_at(problem, conditions, 0.0, 2.0) & solid_x_fixed);
}

TEST(BoundaryConditions, TiedSidesMakeColumnsPeriodic)
{
    Problem problem = box(FixedWall{}, TiedSide{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 4.0};
    const NodeConditions conditions = node_conditions(problem);
    EXPECT_EQ(master_of(problem, conditions, 4.0, 2.0), Vector2(0.0, 2.0));
    EXPECT_EQ(master_of(problem, conditions, -1.0, 2.0), Vector2(3.0, 2.0));
    EXPECT_EQ(master_of(problem, conditions, 5.0, 0.0), Vector2(1.0, 0.0));
    EXPECT_EQ(master_of(problem, conditions, -1.0, -2.0), Vector2(3.0, 0.0)); // below the base as well
    EXPECT_EQ(master_of(problem, conditions, 2.0, 2.0), Vector2(2.0, 2.0));
}

TEST(BoundaryConditions, AViscousCurveIsHeldWhileTheSoilSettles)
{
    Problem problem = box(ViscousFace{}, ViscousFace{});
    const NodeConditions settling = node_conditions(problem, Stage::relaxation);
    // the base as fixed, the sides as rollers
    EXPECT_EQ(conditions_at(problem, settling, 2.0, 0.0), solid_x_fixed | solid_y_fixed | fluid_y_fixed);
    EXPECT_EQ(conditions_at(problem, settling, 0.0, 2.0), solid_x_fixed | fluid_x_fixed);
    const NodeConditions shaking = node_conditions(problem, Stage::shaking);
    EXPECT_EQ(conditions_at(problem, shaking, 2.0, 0.0), seal_y); // the water stays with the grains
    EXPECT_EQ(conditions_at(problem, shaking, 0.0, 2.0), seal_x);
    EXPECT_EQ(master_of(problem, shaking, 2.0, -2.0), Vector2(2.0, 0.0));
}

} // namespace
} // namespace quicksand
