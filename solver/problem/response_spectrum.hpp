// Response spectra: what a motion does to oscillators of one degree of freedom on the shaken base.
#pragma once

#include "solver/problem/base_motion.hpp"

#include <vector>

namespace quicksand {

/// Peaks of an oscillator, of either sign, while the record lasts and over one period of rest behind it.
struct OscillatorPeaks {
    double period = 0.0;                // T [s]
    double displacement = 0.0;          // SD, relative to the base [m]
    double velocity = 0.0;              // SV, relative to the base [m/s]
    double absolute_acceleration = 0.0; // SAa, of base and oscillator together [m/s2]

    double pseudo_velocity() const;     // PSV = (2 pi / T) SD [m/s]
    double pseudo_acceleration() const; // PSA = (2 pi / T)^2 SD [m/s2]
};

/// Periods, as many a decade, from 0.01 s or twice the record's interval, if that is shorter, to 10 s or the
/// duration of a shorter record: those that the record can tell of [s].
std::vector<double> spectral_periods(const SampledMotion& motion, int per_decade = 50);

/// The peaks of one oscillator with the ratio of damping, 0 <= damping < 1. The steps are exact for the
/// record, which is linear between its values [Nigam, Jennings 1969], and so short that a period has a
/// hundred.
OscillatorPeaks oscillator_peaks(const SampledMotion& motion, double period, double damping);

/// oscillator_peaks() for each period.
std::vector<OscillatorPeaks> response_spectrum(const SampledMotion& motion,
                                               const std::vector<double>& periods, double damping);

/// The period of the largest pseudo-acceleration, 0 of a motion without any [s].
double predominant_period(const std::vector<OscillatorPeaks>& spectrum);

} // namespace quicksand
