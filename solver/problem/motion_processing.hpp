// What is done to a record before it shakes a model, and its velocities and displacements.
#pragma once

#include "solver/problem/base_motion.hpp"

#include <vector>

namespace quicksand {

/// The values from one time to the other, both included, with the time counted from the first of them; empty
/// where there are none.
SampledMotion trimmed(const SampledMotion& motion, double from, double to);

/// The record times the factor that gives it this peak, of either sign [m/s2]. Silence stays silent.
SampledMotion scaled_to_peak(SampledMotion motion, double peak);

/// The frequencies that a filter lets pass [Hz].
struct PassBand {
    double lower = 0.0; // corner: half of the amplitude is left; 0: no corner [Hz]
    double upper = 0.0; // likewise, 0: no corner [Hz]
};

/// The record without what lies beyond the band: a Butterworth filter of fourth order, forwards and
/// backwards, so that it moves no phase [Boore 2005]. Zeros are put before and behind the record while it is
/// filtered; what rings into them is cut off.
SampledMotion band_passed(const SampledMotion& motion, const PassBand& band);

/// Velocities and displacements at the values of a record that starts from rest, by the trapezoidal rule.
struct MotionHistories {
    std::vector<double> velocities;    // [m/s]
    std::vector<double> displacements; // [m]
};

MotionHistories histories_of(const SampledMotion& motion);

} // namespace quicksand
