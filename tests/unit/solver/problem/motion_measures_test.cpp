// Measures of a recorded motion against closed forms.
#include "solver/base/conventions.hpp"
#include "solver/problem/motion_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

/// a sin(2 pi t) for ten seconds.
SampledMotion sine_record(double amplitude)
{
    SampledMotion record{0.001, {}};
    for (int k = 0; k <= 10'000; ++k)
        record.accelerations.push_back(amplitude * std::sin(2.0 * std::numbers::pi * 0.001 * k));
    return record;
}

TEST(MotionMeasures, OfASineAreItsClosedForms)
{
    const double a = 2.0, omega = 2.0 * std::numbers::pi;
    const MotionMeasures measures = measure(sine_record(a));
    EXPECT_NEAR(measures.peak_acceleration, a, 1e-12);
    EXPECT_NEAR(measures.peak_time, 0.25, 1e-12);
    EXPECT_NEAR(measures.peak_velocity, 2.0 * a / omega, 1e-5); // (a/omega)(1 - cos)
    // the integral of a^2 sin^2 over whole cycles is a^2 t / 2
    EXPECT_NEAR(measures.arias_intensity, std::numbers::pi / (2.0 * standard_gravity) * a * a * 5.0, 1e-9);
    EXPECT_NEAR(measures.significant_duration, 9.0, 1e-6); // from 0.5 to 9.5 s by symmetry
    EXPECT_NEAR(measures.residual_velocity, 0.0, 1e-12);
    EXPECT_NEAR(measures.residual_displacement, 10.0 * a / omega, 1e-4);
}

TEST(MotionMeasures, OfAConstantAccelerationAreThoseOfAFall)
{
    const MotionMeasures measures = measure({0.5, std::vector<double>(9, 3.0)});
    EXPECT_DOUBLE_EQ(measures.residual_velocity, 12.0);
    EXPECT_DOUBLE_EQ(measures.residual_displacement, 24.0);
    EXPECT_NEAR(measures.significant_duration, 0.9 * 4.0, 1e-12);
}

TEST(MotionMeasures, OfSilenceAreZero)
{
    const MotionMeasures measures = measure({0.01, std::vector<double>(10, 0.0)});
    EXPECT_EQ(measures.arias_intensity, 0.0);
    EXPECT_EQ(measures.significant_duration, 0.0);
}

TEST(HighestFrequency, IsThatOfASineOrOfNearlyAllOfARecord)
{
    EXPECT_EQ(highest_frequency(NoMotion{}), 0.0);
    EXPECT_EQ(highest_frequency(SineMotion{1.0, 7.0, 5.0, 0.0}), 7.0);
    EXPECT_NEAR(highest_frequency(sine_record(2.0)), 1.0, 0.1);
    SampledMotion record = sine_record(1.0);
    const auto add_wave = [&](double amplitude, double frequency) {
        for (std::size_t k = 0; k < record.accelerations.size(); ++k)
            record.accelerations[k] +=
                amplitude * std::sin(2.0 * std::numbers::pi * frequency * 0.001 * static_cast<double>(k));
    };
    add_wave(0.1, 40.0); // one per cent of the intensity
    EXPECT_NEAR(highest_frequency(record), 1.0, 0.2);
    add_wave(0.5, 12.0); // a fifth of it
    EXPECT_NEAR(highest_frequency(record), 12.0, 0.2);
    EXPECT_EQ(highest_frequency(SampledMotion{0.01, std::vector<double>(50, 0.0)}), 0.0);
}

TEST(Baseline, OfALineIsTheLine)
{
    SampledMotion record = sine_record(2.0);
    const SampledMotion reference = without_linear_baseline(record);
    for (std::size_t k = 0; k < record.accelerations.size(); ++k)
        record.accelerations[k] += 0.3 - 0.05 * record.interval * static_cast<double>(k);
    const SampledMotion cleaned = without_linear_baseline(record);
    double largest = 0.0, sum = 0.0;
    for (std::size_t k = 0; k < cleaned.accelerations.size(); ++k) {
        largest = std::max(largest, std::abs(cleaned.accelerations[k] - reference.accelerations[k]));
        sum += cleaned.accelerations[k];
    }
    EXPECT_LT(largest, 1e-12);
    EXPECT_NEAR(sum, 0.0, 1e-9);
}

} // namespace
} // namespace quicksand
