#include "solver/problem/motion_measures.hpp"

#include "solver/base/conventions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <variant>

namespace quicksand {

namespace {

/// Integral of a^2 over the k-th interval by the trapezoid [m2/s3].
double squared_part(const SampledMotion& motion, std::size_t k)
{
    const double a = motion.accelerations[k], b = motion.accelerations[k + 1];
    return 0.5 * motion.interval * (a * a + b * b);
}

/// Time at which the integral of a^2 reaches the fraction of its whole [s].
double time_of_fraction(const SampledMotion& motion, double fraction, double whole)
{
    double before = 0.0;
    for (std::size_t k = 0; k + 1 < motion.accelerations.size(); ++k) {
        const double part = squared_part(motion, k);
        if (part > 0.0 && before + part >= fraction * whole)
            return motion.interval * (static_cast<double>(k) + (fraction * whole - before) / part);
        before += part;
    }
    return duration(motion);
}

/// By the discrete Fourier transform of the record, zeros added up to a power of two.
double highest_frequency(const SampledMotion& record)
{
    constexpr double fraction = 0.95;
    std::size_t count = 1;
    while (count < record.accelerations.size()) count *= 2;
    std::vector<double> padded = record.accelerations;
    padded.resize(count, 0.0);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double>().fwd(spectrum, padded);
    std::vector<double> sums = {0.0}; // over the frequencies k / (count * interval), k >= 1
    for (std::size_t k = 1; k <= count / 2; ++k) sums.push_back(sums.back() + std::norm(spectrum[k]));
    const auto reached = std::find_if(sums.begin(), sums.end(),
                                      [&](double sum) { return sum > 0.0 && sum >= fraction * sums.back(); });
    if (reached == sums.end()) return 0.0;
    return static_cast<double>(reached - sums.begin()) / (static_cast<double>(count) * record.interval);
}

} // namespace

MotionMeasures measure(const SampledMotion& motion)
{
    MotionMeasures measures;
    double velocity = 0.0, displacement = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < motion.accelerations.size(); ++k) {
        const double a = motion.accelerations[k];
        if (std::abs(a) > measures.peak_acceleration) {
            measures.peak_acceleration = std::abs(a);
            measures.peak_time = motion.interval * static_cast<double>(k);
        }
        if (k + 1 == motion.accelerations.size()) break;
        const double next = velocity + 0.5 * motion.interval * (a + motion.accelerations[k + 1]);
        displacement += 0.5 * motion.interval * (velocity + next);
        velocity = next;
        squares += squared_part(motion, k);
        measures.peak_velocity = std::max(measures.peak_velocity, std::abs(velocity));
        measures.peak_displacement = std::max(measures.peak_displacement, std::abs(displacement));
    }
    measures.arias_intensity = std::numbers::pi / (2.0 * standard_gravity) * squares;
    if (squares > 0.0)
        measures.significant_duration =
            time_of_fraction(motion, 0.95, squares) - time_of_fraction(motion, 0.05, squares);
    measures.residual_velocity = velocity;
    measures.residual_displacement = displacement;
    return measures;
}

double highest_frequency(const BaseMotion& motion)
{
    if (const auto* sine = std::get_if<SineMotion>(&motion)) return sine->frequency;
    const auto* record = std::get_if<SampledMotion>(&motion);
    return record != nullptr ? highest_frequency(*record) : 0.0;
}

SampledMotion without_linear_baseline(SampledMotion motion)
{
    const auto count = static_cast<double>(motion.accelerations.size());
    if (count < 2.0) return motion;
    const double middle = 0.5 * (count - 1.0);
    double sum = 0.0, moment = 0.0;
    for (std::size_t k = 0; k < motion.accelerations.size(); ++k) {
        sum += motion.accelerations[k];
        moment += motion.accelerations[k] * (static_cast<double>(k) - middle);
    }
    const double mean = sum / count, slope = 12.0 * moment / (count * (count * count - 1.0));
    for (std::size_t k = 0; k < motion.accelerations.size(); ++k)
        motion.accelerations[k] -= mean + slope * (static_cast<double>(k) - middle);
    return motion;
}

} // namespace quicksand
