// Pictures of a motion: its histories and its response spectra.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "solver/problem/response_spectrum.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// A motion and what its curves are called.
struct NamedMotion {
    std::string name; // in the key; empty: without one
    SampledMotion motion;
    std::vector<OscillatorPeaks> spectrum; // of the motion; may be empty
};

/// Acceleration, velocity and displacement over time, the first motion on top of the others.
LinePlot motion_histories_plot(const std::string& title, const std::string& note,
                               const std::vector<NamedMotion>& motions);

/// Pseudo-acceleration, pseudo-velocity and displacement over the period.
LinePlot motion_spectra_plot(const std::string& title, const std::string& note,
                             const std::vector<NamedMotion>& motions);

} // namespace quicksand
