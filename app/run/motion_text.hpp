// Motions of the base in words.
#pragma once

#include "solver/problem/response_spectrum.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Peaks, intensity, duration and what is left at the end, in three lines; a fourth where the velocity at the
/// end is not zero, which names the `remedy`.
std::string describe_motion_measures(const SampledMotion& motion, const std::string& remedy);

/// Peaks, frequency and cycles of a wave, and what is left at its end, with the remedy where that is a drift.
std::string describe_sine(const SineMotion& sine);

/// For the journal of a run: what a motion leaves its base with where that should be nothing, and the remedy;
/// "" where all is well.
std::string warn_of_drift(const BaseMotion& motion);

/// For the journal of a run whose probes write rows so far apart [s] that the means between them miss peaks
/// of the acceleration; "" where all is well.
std::string warn_of_coarse_rows(const BaseMotion& motion, double interval);

/// The largest pseudo-acceleration and its period, in one line. `damping` in per cent.
std::string describe_spectrum(const std::vector<OscillatorPeaks>& spectrum, double damping);

} // namespace quicksand
