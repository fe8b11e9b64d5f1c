// A level layer shaken by its base in shear: horizontal motion of a uniform column between tied sides, linear
// skeleton with hysteretic damping, the water dragged along by the grains.
#pragma once

#include "solver/verification/solutions/biot_dispersion.hpp"

namespace quicksand {

struct ShearBeam {
    SaturatedSoil soil;
    double height = 1.0;        // H [m]
    double damping_ratio = 0.0; // D of the complex modulus G (1 + 2 i D) [-]
};

/// Total motion at a height x above the base over the motion of the base, at a frequency [Hz]; complex
/// amplitudes of e^{i omega t}: cos[xi (H - x)] / cos(xi H).
Complex shear_transfer(const ShearBeam& beam, double x, double frequency);

} // namespace quicksand
