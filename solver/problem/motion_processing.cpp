#include "solver/problem/motion_processing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <unsupported/Eigen/FFT>

namespace quicksand {

namespace {

constexpr int filter_order = 4;

/// Values to put before and behind a record, so that the filter dies away in them: 1.5 orders of the filter
/// over its lower corner, half of them at each end [Boore 2005].
std::size_t padding(const SampledMotion& motion, const PassBand& band)
{
    if (band.lower <= 0.0) return motion.accelerations.size();
    const double time = 0.5 * 1.5 * 2.0 * filter_order / band.lower; // two passes of the filter [s]
    return static_cast<std::size_t>(std::ceil(time / motion.interval));
}

/// What a Butterworth filter leaves of the amplitude after two passes: 1 / (1 + (f / fc)^2n) of each corner.
double gain(double frequency, const PassBand& band)
{
    double rest = 1.0;
    if (band.lower > 0.0) {
        if (frequency == 0.0) return 0.0;
        rest /= 1.0 + std::pow(band.lower / frequency, 2.0 * filter_order);
    }
    if (band.upper > 0.0) rest /= 1.0 + std::pow(frequency / band.upper, 2.0 * filter_order);
    return rest;
}

std::vector<double> integral(double interval, const std::vector<double>& values)
{
    std::vector<double> sums(values.size(), 0.0);
    for (std::size_t k = 1; k < values.size(); ++k)
        sums[k] = sums[k - 1] + 0.5 * interval * (values[k - 1] + values[k]);
    return sums;
}

} // namespace

SampledMotion trimmed(const SampledMotion& motion, double from, double to)
{
    constexpr double rounding = 1e-6; // of times, in intervals [-]
    SampledMotion part{motion.interval, {}};
    for (std::size_t k = 0; k < motion.accelerations.size(); ++k) {
        const auto place = static_cast<double>(k);
        if (place >= from / motion.interval - rounding && place <= to / motion.interval + rounding)
            part.accelerations.push_back(motion.accelerations[k]);
    }
    return part;
}

SampledMotion scaled_to_peak(SampledMotion motion, double peak)
{
    double present = 0.0;
    for (const double acceleration : motion.accelerations)
        present = std::max(present, std::abs(acceleration));
    if (present == 0.0) return motion;
    for (double& acceleration : motion.accelerations) acceleration *= peak / present;
    return motion;
}

SampledMotion band_passed(const SampledMotion& motion, const PassBand& band)
{
    const std::size_t length = motion.accelerations.size(), before = padding(motion, band);
    std::size_t count = 1;
    while (count < length + 2 * before) count *= 2;
    std::vector<double> padded(count, 0.0);
    std::copy(motion.accelerations.begin(), motion.accelerations.end(),
              padded.begin() + static_cast<std::ptrdiff_t>(before));
    Eigen::FFT<double> transform;
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, padded);
    for (std::size_t k = 0; k < count; ++k) {
        const auto waves = static_cast<double>(std::min(k, count - k)); // over the whole length [-]
        spectrum[k] *= gain(waves / (static_cast<double>(count) * motion.interval), band);
    }
    transform.inv(padded, spectrum);
    const auto first = padded.begin() + static_cast<std::ptrdiff_t>(before);
    return {motion.interval, {first, first + static_cast<std::ptrdiff_t>(length)}};
}

MotionHistories histories_of(const SampledMotion& motion)
{
    MotionHistories histories;
    histories.velocities = integral(motion.interval, motion.accelerations);
    histories.displacements = integral(motion.interval, histories.velocities);
    return histories;
}

} // namespace quicksand
