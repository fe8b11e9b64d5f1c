// Response spectra against the closed forms of an oscillator.
#include "solver/base/conventions.hpp"
#include "solver/problem/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

constexpr double pi = std::numbers::pi;

/// a sin(2 pi f t) in `steps` values a period, over whole periods.
SampledMotion whole_periods(double amplitude, double frequency, int periods, int steps)
{
    SampledMotion record{1.0 / (frequency * steps), {}};
    for (int k = 0; k <= periods * steps; ++k)
        record.accelerations.push_back(amplitude * std::sin(2.0 * pi * k / steps));
    return record;
}

// From rest under -a the displacement is -a/w^2 (1 - e^(-Dwt) (cos wd t + D w/wd sin wd t)), which peaks at
// wd t = pi with 1 + e^(-pi D / sqrt(1 - D^2)); the velocity peaks where its derivative vanishes, at
// tan(wd t) = wd / (D w).
TEST(ResponseSpectrum, OfAStepIsItsClosedForm)
{
    const double a = 3.0, period = 0.4, w = 2.0 * pi / period;
    const SampledMotion step{0.002, std::vector<double>(5001, a)};
    for (const double damping : {0.0, 0.05, 0.2}) {
        const double root = std::sqrt(1.0 - damping * damping), wd = w * root;
        const OscillatorPeaks peaks = oscillator_peaks(step, period, damping);
        const double overshoot = 1.0 + std::exp(-pi * damping / root);
        const double reached = 0.5 * std::pow(pi / 100.0, 2) / 4.0; // a peak lies half a step beside
        if (damping > 0.0) {
            EXPECT_NEAR(peaks.displacement, a / (w * w) * overshoot, reached * a / (w * w));
            const double time = std::atan2(root, damping) / wd;
            EXPECT_NEAR(peaks.velocity, a / wd * std::exp(-damping * w * time) * std::sin(wd * time),
                        4.0 * reached * a / w);
        }
        EXPECT_NEAR(peaks.pseudo_acceleration(), w * w * peaks.displacement, 1e-12 * a);
    }
    // Without damping the step's end at t = 25 periods finds the oscillator at rest: 1 - cos is 0.
    EXPECT_NEAR(oscillator_peaks(step, period, 0.0).displacement, 2.0 * a / (w * w), 1e-3 * a / (w * w));
}

// In the steady state SD = a / sqrt((w^2 - p^2)^2 + (2 D w p)^2); an oscillator that has forgotten its start
// swings between these.
TEST(ResponseSpectrum, OfALongSineIsItsSteadyStateAtResonance)
{
    const double a = 2.0, frequency = 2.0, damping = 0.05, p = 2.0 * pi * frequency;
    const SampledMotion record = whole_periods(a, frequency, 60, 400);
    const OscillatorPeaks peaks = oscillator_peaks(record, 1.0 / frequency, damping);
    const double steady = a / (2.0 * damping * p * p);
    EXPECT_NEAR(peaks.displacement, steady, 2e-4 * steady);
    EXPECT_NEAR(peaks.velocity, p * steady, 2e-4 * p * steady);
    // u and u' are a quarter of a period apart: the absolute acceleration is w^2 sqrt(1 + 4 D^2) u
    const double absolute = p * p * steady * std::sqrt(1.0 + 4.0 * damping * damping);
    EXPECT_NEAR(peaks.absolute_acceleration, absolute, 2e-4 * absolute);
}

// From rest, undamped: u = -a / (w^2 - p^2) (sin pt - (p / w) sin wt).
TEST(ResponseSpectrum, OfASineFromRestIsItsClosedForm)
{
    const double a = 1.5, frequency = 2.0, p = 2.0 * pi * frequency;
    const SampledMotion record = whole_periods(a, frequency, 3, 2000);
    for (const double period : {0.2, 0.7, 1.3}) {
        const double w = 2.0 * pi / period;
        double expected = 0.0;
        const auto at = [&](double t) {
            return (std::sin(p * t) - p / w * std::sin(w * t)) / (w * w - p * p);
        };
        for (int k = 0; k <= 150'000; ++k) expected = std::max(expected, std::abs(a * at(1e-5 * k)));
        // free afterwards: the amplitude of what it has at the end
        const double end = 1.5, speed = a * (p * std::cos(p * end) - p * std::cos(w * end)) / (w * w - p * p);
        expected = std::max(expected, std::hypot(a * at(end), speed / w));
        EXPECT_NEAR(oscillator_peaks(record, period, 0.0).displacement, expected, 6e-4 * expected) << period;
    }
}

TEST(ResponseSpectrum, IsExactForStraightLinesHoweverLongTheyAre)
{
    // a ramp in one piece and in a thousand
    const double end = 2.0;
    const SampledMotion coarse{end, {0.0, 4.0}};
    SampledMotion fine{end / 1000, {}};
    for (int k = 0; k <= 1000; ++k) fine.accelerations.push_back(4.0 * k / 1000);
    const OscillatorPeaks one = oscillator_peaks(coarse, 0.5, 0.05), many = oscillator_peaks(fine, 0.5, 0.05);
    EXPECT_NEAR(one.displacement, many.displacement, 5e-4 * many.displacement);
    EXPECT_NEAR(one.velocity, many.velocity, 5e-4 * many.velocity);
}

TEST(ResponseSpectrum, OfStiffAndOfSoftOscillatorsIsTheMotionItself)
{
    const SampledMotion record = whole_periods(2.0, 1.0, 10, 1000);
    // A stiff one rides with the base. A soft one stays behind: SD is the base's largest way, a t / p.
    EXPECT_NEAR(oscillator_peaks(record, 0.01, 0.05).pseudo_acceleration(), 2.0, 1e-3);
    const double way = 2.0 * 10.0 / (2.0 * pi);
    EXPECT_NEAR(oscillator_peaks(record, 2000.0, 0.0).displacement, way, 0.01 * way);
    const auto spectrum = response_spectrum(record, spectral_periods(record), 0.05);
    EXPECT_NEAR(predominant_period(spectrum), 1.0, 0.03);
    EXPECT_EQ(predominant_period(response_spectrum({0.01, {0.0, 0.0}}, {0.1, 1.0}, 0.05)), 0.0);
}

TEST(SpectralPeriods, AreThoseThatARecordCanTellOf)
{
    const auto ends = [](double interval, std::size_t count) {
        const std::vector<double> periods = spectral_periods({interval, std::vector<double>(count, 0.0)});
        return std::pair(periods.front(), periods.back());
    };
    EXPECT_DOUBLE_EQ(ends(0.005, 8001).first, 0.01);
    EXPECT_DOUBLE_EQ(ends(0.005, 8001).second, 10.0);
    EXPECT_DOUBLE_EQ(ends(1e-4, 5001).first, 2e-4) << "in a centrifuge";
    EXPECT_DOUBLE_EQ(ends(1e-4, 5001).second, 0.5);
    EXPECT_DOUBLE_EQ(ends(0.1, 2).second, 0.1);
}

} // namespace
} // namespace quicksand
