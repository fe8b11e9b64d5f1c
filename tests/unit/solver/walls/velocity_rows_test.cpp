// Rows that nearly say what others do, and rows that are gone.
#include "solver/walls/velocity_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

void add_row(std::size_t node, double x, double y, VelocityRows& rows)
{
    rows.begin_row(0.0);
    rows.add(node, NodeVelocities(x, y, 0.0, 0.0));
}

// Steps that factorise the rows with others choose the precision by it: a run that goes on and one that is
// resumed have to choose alike.
TEST(VelocityRows, TellHowNearlyTheyRepeatEachOtherNowAndNotBefore)
{
    VelocityRows rows;
    rows.clear(4);
    add_row(1, 1.0, 0.0, rows);
    add_row(1, 1.0, 1e-3, rows);
    rows.begin_followers();
    rows.factorise({NodeInverse::Identity()});
    EXPECT_NEAR(rows.smallest_pivot(), 1e-6, 1e-8);

    rows.clear(4);
    rows.begin_followers();
    rows.factorise({});
    EXPECT_EQ(rows.smallest_pivot(), 1.0);
}

// A slope whose toe ended in such rows never came to rest while their difference held it in part.
TEST(VelocityRows, ThatNearlyRepeatEachOtherHoldWhatTheyHaveInCommon)
{
    VelocityRows rows;
    rows.clear(2);
    add_row(1, 1.0, 0.0, rows);
    add_row(1, 1.0, 1e-6, rows);
    rows.begin_followers();
    rows.factorise({NodeInverse::Identity()});
    const NodeVelocities gained(1.0, 1.0, 0.0, 0.0);
    std::vector<NodeVelocities> velocities = {gained};
    const NodeVelocities left = gained + rows.impulses(rows.project(velocities))[0];
    EXPECT_LT((left - velocities[0]).norm(), 1e-9); // forces as velocities
    EXPECT_LT(std::abs(left.x()), 1e-6);
    EXPECT_NEAR(left.y(), 1.0, 0.01);
}

// Soil above the ground water that reaches a node by its grains alone was left free there: hardly any water
// answers by other orders than grains.
TEST(VelocityRows, HoldGrainsBesideHardlyAnyWater)
{
    VelocityRows rows;
    rows.clear(2);
    rows.begin_followers();
    for (const NodeVelocities& row :
         {NodeVelocities(1.0, 0.0, 0.0, 0.0), NodeVelocities(-1.0, 0.0, 1.0, 0.0)}) {
        rows.begin_row(0.0);
        rows.add(1, row);
    }
    NodeInverse inverse = NodeInverse::Identity();
    inverse(2, 2) = inverse(3, 3) = 1e20;
    rows.factorise({inverse});
    std::vector<NodeVelocities> velocities = {NodeVelocities(1.0, 2.0, 3.0, 4.0)};
    rows.hold(velocities);
    EXPECT_NEAR((velocities[0] - NodeVelocities(0.0, 2.0, 0.0, 4.0)).norm(), 0.0, 1e-9);
}

} // namespace
} // namespace quicksand
