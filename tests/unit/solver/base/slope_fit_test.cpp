// The slope from a cell to its neighbours: exact for linear quantities, bounded where the cells lie in a row.
#include "solver/base/slope_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

namespace quicksand {
namespace {

constexpr double h = 0.5; // [m]

SlopeFit fit(const std::vector<Vector2>& apart, const Vector2& slope)
{
    SlopeFit fit;
    for (const Vector2& d : apart) fit.add(d, slope.dot(d));
    return fit;
}

TEST(SlopeFit, IsThatOfALinearQuantity)
{
    const Vector2 slope(3.0, -2.0);
    for (const std::vector<Vector2>& apart :
         {std::vector<Vector2>{{h, 0.0}, {0.0, h}}, {{-h, 0.1 * h}, {0.6 * h, 0.6 * h}, {h, 0.0}}})
        EXPECT_LT((fit(apart, slope).slope(h) - slope).norm(), 1e-14);
}

TEST(SlopeFit, GoesAlongARowOfCells)
{
    const std::vector<Vector2> row = {{-h, 0.0}, {h, 0.0}};
    EXPECT_LT((fit(row, {3.0, -2.0}).slope(h) - Vector2(3.0, 0.0)).norm(), 1e-14);
    EXPECT_EQ(SlopeFit{}.slope(h), Vector2(0.0, 0.0));
}

// A difference of 1 would be a slope of 20 across the row, where the centres lie 0.1 of a cell beside each
// other.
TEST(SlopeFit, IsNoneAcrossARowThatIsNotQuiteStraight)
{
    for (const double angle : {0.0, 0.5, 1.2, 2.4}) {
        SlopeFit bent;
        bent.add(Eigen::Rotation2Dd(angle) * Vector2(-h, 0.1 * h), 1.0);
        bent.add(Eigen::Rotation2Dd(angle) * Vector2(h, 0.1 * h), 1.0);
        EXPECT_LT(bent.slope(h).norm(), 0.11 / h) << angle;
    }
}

constexpr double weights[] = {1.0, 0.3, 2.0}; // of neighbours

TEST(PlaneFit, IsThatOfALinearQuantity)
{
    const Vector2 slope(3.0, -2.0);
    const Vector2 apart[] = {{-h, 0.1 * h}, {0.6 * h, 0.6 * h}, {h, 0.0}};
    PlaneFit plane;
    for (int k = 0; k < 3; ++k) plane.add(weights[k], apart[k], slope.dot(apart[k]));
    EXPECT_LT((plane.slope(h) - slope).norm(), 1e-14);
    EXPECT_EQ(PlaneFit{}.slope(h), Vector2(0.0, 0.0));
}

// Beside a wall: cells above, below and on one side, and a quantity that bends along the wall alone.
TEST(PlaneFit, HasNoSlopeAcrossAnEndAtWhichNothingChanges)
{
    PlaneFit plane;
    for (const Vector2& apart :
         {Vector2(0.0, h), Vector2(0.0, -h), Vector2(h, h), Vector2(h, 0.0), Vector2(h, -h)})
        plane.add(1.0, apart, 7.0 * apart.y() * apart.y() + 2.0 * apart.y());
    EXPECT_LT((plane.slope(h) - Vector2(0.0, 2.0)).norm(), 1e-14);
}

TEST(PlaneFit, GoesAlongARowOfCellsThatEnds)
{
    PlaneFit plane;
    plane.add(weights[1], {h, 0.0}, 3.0 * h);
    EXPECT_LT((plane.slope(h) - Vector2(3.0, 0.0)).norm(), 1e-14);
}

} // namespace
} // namespace quicksand
