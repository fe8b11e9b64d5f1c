// What engineers call a recorded motion by: its peaks, its intensity, its duration and its baseline.
#pragma once

#include "solver/problem/base_motion.hpp"

namespace quicksand {

/// Measures of a record that starts from rest; integrals by the trapezoidal rule.
struct MotionMeasures {
    double peak_acceleration = 0.0;     // PGA, of either sign [m/s2]
    double peak_time = 0.0;             // of PGA [s]
    double peak_velocity = 0.0;         // PGV [m/s]
    double peak_displacement = 0.0;     // PGD [m]
    double arias_intensity = 0.0;       // pi/(2 g) integral of a^2 dt [m/s] [Arias 1970]
    double significant_duration = 0.0;  // D5-95, from 5 to 95 % of the intensity [s] [Trifunac, Brady 1975]
    double residual_velocity = 0.0;     // at the end of the record [m/s]
    double residual_displacement = 0.0; // [m]
};

MotionMeasures measure(const SampledMotion& motion);

/// The frequency of a sine, or that below which a record has 95 % of its intensity; 0 without shaking [Hz].
double highest_frequency(const BaseMotion& motion);

/// The record without the straight line that fits its accelerations best (least squares). The velocity then
/// ends near zero, for the accelerations add up to zero.
SampledMotion without_linear_baseline(SampledMotion motion);

} // namespace quicksand
