// What is done to records, against waves and straight lines.
#include "solver/problem/motion_measures.hpp"
#include "solver/problem/motion_processing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

/// 40 s of sines in steps of 0.01 s, each with its frequency, that rise and fade.
SampledMotion waves(const std::vector<double>& frequencies)
{
    SampledMotion record{0.01, {}};
    for (int k = 0; k <= 4000; ++k) {
        const double t = 0.01 * k, envelope = std::pow(std::sin(std::numbers::pi * t / 40.0), 2);
        double sum = 0.0;
        for (const double frequency : frequencies) sum += std::sin(2.0 * std::numbers::pi * frequency * t);
        record.accelerations.push_back(envelope * sum);
    }
    return record;
}

double largest_difference(const SampledMotion& a, const SampledMotion& b, double factor = 1.0)
{
    double largest = 0.0;
    for (std::size_t k = 0; k < a.accelerations.size(); ++k)
        largest = std::max(largest, std::abs(a.accelerations[k] - factor * b.accelerations[k]));
    return largest;
}

TEST(BandPass, KeepsWhatLiesInItAndTakesTheRest)
{
    const SampledMotion passed = band_passed(waves({0.1, 2.0, 30.0}), {0.4, 10.0});
    ASSERT_EQ(passed.accelerations.size(), 4001U);
    EXPECT_LT(largest_difference(passed, waves({2.0})), 1e-3) << "and leaves its phase";
}

// The envelope spreads a wave over f +- 1/40 Hz, where the gain is 0.5 +- 2 / (40 f).
TEST(BandPass, HalvesTheAmplitudeAtItsCorners)
{
    EXPECT_LT(largest_difference(band_passed(waves({5.0}), {5.0, 0.0}), waves({5.0}), 0.5), 0.01);
    EXPECT_LT(largest_difference(band_passed(waves({5.0}), {0.0, 5.0}), waves({5.0}), 0.5), 0.01);
}

TEST(BandPass, WithoutCornersIsTheRecord)
{
    EXPECT_LT(largest_difference(band_passed(waves({1.0, 7.0}), {}), waves({1.0, 7.0})), 1e-12);
}

TEST(Trimming, KeepsTheValuesBetweenTheTimes)
{
    const SampledMotion record{0.1, {0.0, 1.0, 2.0, 3.0, 4.0}};
    EXPECT_EQ(trimmed(record, 0.1, 0.3).accelerations, (std::vector{1.0, 2.0, 3.0}));
    EXPECT_EQ(trimmed(record, 0.11, 9.0).accelerations, (std::vector{2.0, 3.0, 4.0}));
    EXPECT_TRUE(trimmed(record, 5.0, 9.0).accelerations.empty());
}

TEST(Scaling, GivesAPeak)
{
    EXPECT_EQ(scaled_to_peak({0.1, {0.0, 1.0, -4.0}}, 2.0).accelerations, (std::vector{0.0, 0.5, -2.0}));
    EXPECT_EQ(scaled_to_peak({0.1, {0.0, 0.0}}, 2.0).accelerations, (std::vector{0.0, 0.0}));
}

TEST(MotionHistories, EndWhereTheMeasuresDo)
{
    const SampledMotion record{0.5, std::vector<double>(9, 3.0)};
    const MotionHistories histories = histories_of(record);
    EXPECT_DOUBLE_EQ(histories.velocities.back(), measure(record).residual_velocity);
    EXPECT_DOUBLE_EQ(histories.displacements.back(), measure(record).residual_displacement);
    EXPECT_EQ(histories.velocities.front(), 0.0);
}

} // namespace
} // namespace quicksand
