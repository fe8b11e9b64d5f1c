#include "solver/verification/solutions/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

Convergence series(std::vector<int> cells, std::vector<double> errors)
{
    Convergence result;
    result.cells = std::move(cells);
    result.errors = std::move(errors);
    result.limits.assign(result.errors.size(), none);
    result.seconds.assign(result.errors.size(), 1.0);
    return result;
}

TEST(MeasuredOrder, IsTheExponentOfAPowerLaw)
{
    EXPECT_NEAR(measured_order(series({10, 20, 40}, {0.4, 0.1, 0.025})), 2.0, 1e-12);
    EXPECT_NEAR(measured_order(series({8, 24}, {0.3, 0.1})), 1.0, 1e-12);
}

TEST(MeasuredOrder, IsTheLeastSquaresSlopeOfErrorsThatFollowNone)
{
    // halvings of 1 and of 3: least squares through three equally spaced points is the mean
    EXPECT_NEAR(measured_order(series({10, 20, 40}, {0.16, 0.08, 0.01})), 2.0, 1e-12);
}

TEST(MeasuredOrder, IsNoneForOneGridOrAnErrorOfZero)
{
    EXPECT_TRUE(std::isnan(measured_order(series({10}, {0.1}))));
    EXPECT_TRUE(std::isnan(measured_order(series({10, 20}, {0.1, 0.0}))));
}

TEST(Requirements, AreMissedByARunThatWentBadWhereSomethingIsRequired)
{
    Convergence result = series({10, 20}, {none, 0.1});
    EXPECT_TRUE(std::isnan(measured_order(result)));
    EXPECT_TRUE(meets_requirements(result));
    result.least_order = 1.0;
    EXPECT_FALSE(meets_requirements(result));
    result = series({10, 20}, {none, 0.1});
    result.limits = {0.5, 0.5};
    EXPECT_FALSE(meets_requirements(result));
}

TEST(Requirements, AreMetUpToTheLimitOfEveryGrid)
{
    Convergence result = series({10, 20}, {0.4, 0.1});
    EXPECT_TRUE(meets_requirements(result));
    result.limits = {none, 0.1};
    EXPECT_TRUE(meets_requirements(result));
    result.limits = {0.3, 0.1};
    EXPECT_FALSE(meets_requirements(result));
}

TEST(Requirements, AreMissedByAnErrorThatIsNoNumber)
{
    EXPECT_FALSE(meets_requirements(series({10, 20}, {0.4, std::nan("")})));
}

TEST(Requirements, AskForTheOrderWhereThereAreTwoGrids)
{
    Convergence result = series({10, 20}, {0.4, 0.1});
    result.least_order = 1.9;
    EXPECT_TRUE(meets_requirements(result));
    result.least_order = 2.1;
    EXPECT_FALSE(meets_requirements(result));
    Convergence alone = series({10}, {0.4});
    alone.least_order = 2.1;
    EXPECT_TRUE(meets_requirements(alone));
}

} // namespace
} // namespace quicksand
