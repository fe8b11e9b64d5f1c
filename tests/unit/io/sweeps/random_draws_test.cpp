#include "io/sweeps/fragility_fit.hpp"
#include "io/sweeps/random_draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

std::pair<double, double> mean_and_deviation(const std::vector<double>& values)
{
    const auto count = static_cast<double>(values.size());
    double mean = 0.0, squares = 0.0;
    for (const double value : values) mean += value / count;
    for (const double value : values) squares += (value - mean) * (value - mean) / count;
    return {mean, std::sqrt(squares)};
}

constexpr Distribution normal{DistributionKind::normal, 3.0, 0.5, 0.0, 0.0, ""};
constexpr std::int64_t many = 40'000; // the mean's own deviation is then 0.005 of the key's

} // namespace

TEST(NormalQuantile, InvertsTheNormalDistribution)
{
    for (const double share :
         {1e-300, 1e-20, 1e-6, 0.01, 0.0749, 0.0751, 0.3, 0.5, 0.7, 0.926, 0.99, 1.0 - 1e-9})
        EXPECT_NEAR(normal_share(normal_quantile(share)) / share, 1.0, share < 1e-100 ? 1e-12 : 1e-13)
            << share;
    EXPECT_EQ(normal_quantile(0.5), 0.0);
    EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
}

TEST(Draws, HaveTheirMoments)
{
    const auto [mean, deviation] = mean_and_deviation(draw_values(normal, 1, "k", many));
    EXPECT_NEAR(mean, 3.0, 0.01);
    EXPECT_NEAR(deviation, 0.5, 0.01);

    Distribution lognormal = normal;
    lognormal.kind = DistributionKind::lognormal;
    lognormal.deviation = 1.5;
    const std::vector<double> values = draw_values(lognormal, 1, "k", many);
    const auto [of_lognormal, spread] = mean_and_deviation(values);
    EXPECT_NEAR(of_lognormal, 3.0, 0.03) << "of the key itself, not of its logarithm";
    EXPECT_NEAR(spread, 1.5, 0.05);
    EXPECT_GT(*std::min_element(values.begin(), values.end()), 0.0);

    const Distribution uniform{DistributionKind::uniform, 0.0, 0.0, 2.0, 5.0, ""};
    const std::vector<double> spans = draw_values(uniform, 1, "k", many);
    EXPECT_NEAR(mean_and_deviation(spans).first, 3.5, 0.02);
    EXPECT_NEAR(mean_and_deviation(spans).second, 3.0 / std::sqrt(12.0), 0.01);
    EXPECT_GE(*std::min_element(spans.begin(), spans.end()), 2.0);
    EXPECT_LE(*std::max_element(spans.begin(), spans.end()), 5.0);
}

TEST(Draws, AreTheSameForASeedOnEveryMachine)
{
    const Distribution uniform{DistributionKind::uniform, 0.0, 0.0, 0.0, 1.0, ""};
    const std::vector<double> values = draw_values(uniform, 1, "motion.amplitude", 3);
    EXPECT_EQ(values, draw_values(uniform, 1, "motion.amplitude", 3));
    EXPECT_NEAR(values[0], 0.1714376457761551, 1e-15)
        << "by the generator and the hash written down in Python";
    EXPECT_NE(values, draw_values(uniform, 2, "motion.amplitude", 3));
}

TEST(Draws, FurtherSamplesAndKeysLeaveTheFormerOnes)
{
    const std::vector<double> few = draw_values(normal, 7, "a", 5), more = draw_values(normal, 7, "a", 9);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin()));
    EXPECT_NE(few, draw_values(normal, 7, "b", 5));
}

} // namespace quicksand
