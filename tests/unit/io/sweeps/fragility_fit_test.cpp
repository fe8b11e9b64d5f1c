#include "io/sweeps/fragility_fit.hpp"
#include "io/sweeps/random_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

namespace {

void add_runs(std::vector<FragilityPoint>& points, double intensity, int runs, int exceeding)
{
    for (int k = 0; k < runs; ++k) points.push_back({intensity, k < exceeding});
}

} // namespace

// With two intensities the curve goes through both shares: beta = ln(x2 / x1) / (z2 - z1).
TEST(FragilityFit, OfTwoIntensitiesIsTheClosedForm)
{
    std::vector<FragilityPoint> points;
    add_runs(points, 0.1, 10, 2);
    add_runs(points, 0.4, 20, 15);
    const FragilityFit fit = fit_fragility(points);
    ASSERT_TRUE(fit.curve) << fit.why_not;
    const double z1 = normal_quantile(0.2), z2 = normal_quantile(0.75), beta = std::log(4.0) / (z2 - z1);
    EXPECT_NEAR(fit.curve->beta, beta, 1e-9);
    EXPECT_NEAR(fit.curve->median, 0.1 * std::exp(-z1 * beta), 1e-9);
    EXPECT_NEAR(fit.curve->probability(0.1), 0.2, 1e-9);
    EXPECT_NEAR(fit.curve->probability(0.4), 0.75, 1e-9);
}

// Each run exceeds where its own strength, lognormal with median 0.3 and beta 0.4, is below the intensity.
TEST(FragilityFit, FindsTheCurveThatRunsWereDrawnFrom)
{
    const FragilityCurve truth{0.3, 0.4};
    const Distribution share{DistributionKind::uniform, 0.0, 0.0, 0.0, 1.0, ""};
    const std::vector<double> draws = draw_values(share, 1, "run", 20'000);
    std::vector<FragilityPoint> points;
    for (std::size_t k = 0; k < draws.size(); ++k) {
        const double intensity = 0.05 * static_cast<double>(1 + k % 20);
        points.push_back({intensity, draws[k] < truth.probability(intensity)});
    }
    const FragilityFit fit = fit_fragility(points);
    ASSERT_TRUE(fit.curve) << fit.why_not;
    EXPECT_NEAR(fit.curve->median, 0.3, 0.01);
    EXPECT_NEAR(fit.curve->beta, 0.4, 0.02);
}

TEST(FragilityFit, DoesNotDependOnTheUnit)
{
    std::vector<FragilityPoint> points, in_other_unit;
    add_runs(points, 0.1, 5, 1);
    add_runs(points, 0.2, 5, 2);
    add_runs(points, 0.3, 5, 4);
    for (const FragilityPoint& point : points)
        in_other_unit.push_back({9.81 * point.intensity, point.exceeds});
    const FragilityFit fit = fit_fragility(points), other = fit_fragility(in_other_unit);
    ASSERT_TRUE(fit.curve && other.curve);
    EXPECT_NEAR(other.curve->median / fit.curve->median, 9.81, 1e-7);
    EXPECT_NEAR(other.curve->beta, fit.curve->beta, 1e-8);
}

TEST(FragilityFit, TellsWhyThereIsNoCurve)
{
    const auto why = [](const std::vector<FragilityPoint>& points) { return fit_fragility(points).why_not; };
    EXPECT_EQ(why({}), "no run has a value");
    EXPECT_EQ(why({{1.0, false}, {2.0, false}}), "no run exceeds the threshold");
    EXPECT_EQ(why({{1.0, true}, {2.0, true}}), "all runs exceed the threshold");
    EXPECT_EQ(
        why({{1.0, false}, {2.0, false}, {3.0, true}}),
        "the runs up to 2 do not exceed the threshold and those from 3 on do: the median lies between, and "
        "beta needs runs that differ at an intensity");
    EXPECT_EQ(why({{1.0, true}, {2.0, false}}),
              "the runs of small intensity exceed the threshold, the others not");
    EXPECT_EQ(why({{1.0, true}, {1.0, false}, {2.0, true}, {2.0, false}, {2.0, false}}),
              "runs of larger intensity do not exceed the threshold more often");
}

} // namespace quicksand
