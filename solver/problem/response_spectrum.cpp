#include "solver/problem/response_spectrum.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

/// u'' + 2 D w u' + w^2 u = -a(t) over steps of one length, on which a is linear:
///     u(t) = (2 D s / w^3 - a0 / w^2) - s t / w^2 + e^(-D w t) (c1 cos(wd t) + c2 sin(wd t))
/// with a = a0 + s t, wd = w sqrt(1 - D^2), and c1, c2 from u and u' at the start of the step.
class Oscillator {
public:
    Oscillator(double period, double damping, double step)
        : frequency_(2.0 * std::numbers::pi / period), damping_(damping), step_(step),
          damped_(frequency_ * std::sqrt(1.0 - damping * damping)), decay_(damping * frequency_),
          fading_(std::exp(-decay_ * step)), cosine_(fading_ * std::cos(damped_ * step)),
          sine_(fading_ * std::sin(damped_ * step))
    {
        peaks_.period = period;
    }

    /// A step over which the base's acceleration goes from `before` to `after` [m/s2].
    void advance(double before, double after)
    {
        const double square = frequency_ * frequency_, slope = (after - before) / step_;
        const double constant = (2.0 * damping_ * slope / frequency_ - before) / square;
        const double c1 = displacement_ - constant;
        const double c2 = (velocity_ + slope / square + decay_ * c1) / damped_;
        displacement_ = constant - slope * step_ / square + c1 * cosine_ + c2 * sine_;
        velocity_ = -slope / square + c1 * (-decay_ * cosine_ - damped_ * sine_) +
                    c2 * (damped_ * cosine_ - decay_ * sine_);
        const double absolute = 2.0 * decay_ * velocity_ + square * displacement_; // -(u'' + a)
        peaks_.displacement = std::max(peaks_.displacement, std::abs(displacement_));
        peaks_.velocity = std::max(peaks_.velocity, std::abs(velocity_));
        peaks_.absolute_acceleration = std::max(peaks_.absolute_acceleration, std::abs(absolute));
    }

    const OscillatorPeaks& peaks() const { return peaks_; }

private:
    double frequency_;          // w [1/s]
    double damping_;            // D [-]
    double step_;               // [s]
    double damped_;             // wd [1/s]
    double decay_;              // D w [1/s]
    double fading_;             // e^(-D w step) [-]
    double cosine_;             // e^(-D w step) cos(wd step) [-]
    double sine_;               // [-]
    double displacement_ = 0.0; // u [m]
    double velocity_ = 0.0;     // [m/s]
    OscillatorPeaks peaks_;
};

} // namespace

double OscillatorPeaks::pseudo_velocity() const
{
    return 2.0 * std::numbers::pi / period * displacement;
}

double OscillatorPeaks::pseudo_acceleration() const
{
    return 2.0 * std::numbers::pi / period * pseudo_velocity();
}

std::vector<double> spectral_periods(const SampledMotion& motion, int per_decade)
{
    constexpr double usual_shortest = 0.01, usual_longest = 10.0; // of engineers' spectra [s]
    const double shortest = std::min(usual_shortest, 2.0 * motion.interval);
    const double longest = std::max(std::min(usual_longest, duration(motion)), 2.0 * shortest);
    const double decades = std::log10(longest / shortest);
    const int count = std::max(1, static_cast<int>(std::ceil(decades * per_decade - 1e-9)));
    std::vector<double> periods;
    for (int k = 0; k <= count; ++k) periods.push_back(shortest * std::pow(10.0, decades * k / count));
    return periods;
}

OscillatorPeaks oscillator_peaks(const SampledMotion& motion, double period, double damping)
{
    ENSURE(period > 0.0 && damping >= 0.0 && damping < 1.0 && motion.interval > 0.0);
    constexpr double steps_per_period = 100.0;
    const auto parts =
        static_cast<int>(std::max(1.0, std::ceil(steps_per_period * motion.interval / period)));
    Oscillator oscillator(period, damping, motion.interval / parts);
    for (std::size_t k = 0; k + 1 < motion.accelerations.size(); ++k) {
        const double first = motion.accelerations[k], change = motion.accelerations[k + 1] - first;
        for (int part = 0; part < parts; ++part)
            oscillator.advance(first + change * part / parts, first + change * (part + 1) / parts);
    }
    const double steps_of_rest = std::ceil(period * parts / motion.interval);
    for (double step = 0.0; step < steps_of_rest; step += 1.0) oscillator.advance(0.0, 0.0);
    return oscillator.peaks();
}

std::vector<OscillatorPeaks> response_spectrum(const SampledMotion& motion,
                                               const std::vector<double>& periods, double damping)
{
    std::vector<OscillatorPeaks> spectrum;
    spectrum.reserve(periods.size());
    for (const double period : periods) spectrum.push_back(oscillator_peaks(motion, period, damping));
    return spectrum;
}

double predominant_period(const std::vector<OscillatorPeaks>& spectrum)
{
    double period = 0.0, largest = 0.0; // [s], [m/s2]
    for (const OscillatorPeaks& peaks : spectrum) {
        if (peaks.pseudo_acceleration() <= largest) continue;
        largest = peaks.pseudo_acceleration();
        period = peaks.period;
    }
    return period;
}

} // namespace quicksand
