// Plane waves of the coupled solid-water equations (Biot 1956), as the two-phase step solves them: linear
// skeleton, compressible water, incompressible grains, drag C (v_w - v_s), no tortuosity.
//
// Travelling waves e^{i(omega t - xi x)}, xi complex: decaying in +x where Im xi < 0.
// Standing waves e^{s t} sin(xi x), xi real, as a periodic cell or a box between rollers holds them: decaying
// where Re s < 0.
#pragma once

#include "solver/verification/solutions/saturated_soil.hpp"

#include <array>
#include <complex>

namespace quicksand {

using Complex = std::complex<double>;

/// One of the two longitudinal waves e^{s t} e^{+-kappa x} at a complex frequency s.
struct LongitudinalWave {
    Complex kappa_squared; // [1/m2]
    Eigen::Vector2cd mode; // displacement of (solid, fluid), to a common factor
};

/// The fast and the slow wave, in this order, at a complex frequency s [1/s] that is not zero.
std::array<LongitudinalWave, 2> longitudinal_waves(const SaturatedSoil& soil, Complex s);

/// xi^2 of the shear wave at a complex frequency s [1/m2]; the water is dragged along only. The shear modulus
/// may be complex, for hysteretic damping [Pa].
Complex shear_wave_number_squared(const SaturatedSoil& soil, Complex s, Complex shear_modulus);

/// Wave speeds without drag, the limit of high frequency [m/s].
struct UndraggedSpeeds {
    double fast, slow, shear;
};
UndraggedSpeeds undragged_speeds(const SaturatedSoil& soil);

/// Complex frequencies s of the standing longitudinal waves of a real wave number [1/s]: the fast wave with
/// Im s > 0 (its conjugate is a mode too), and two that are real where the slow wave cannot travel: `slow`
/// decays as consolidation does, `relative` as the drag stops the relative motion. Where it can travel these
/// two are conjugates, `slow` with Im s > 0.
struct LongitudinalModes {
    Complex fast, slow, relative;
};
LongitudinalModes longitudinal_modes(const SaturatedSoil& soil, double wave_number);

/// The same of standing shear waves: one oscillation, Im s > 0, and the decay of the relative motion.
struct ShearModes {
    Complex shear, relative;
};
ShearModes shear_modes(const SaturatedSoil& soil, double wave_number);

/// Displacement of the water over that of the solid in a standing shear wave of complex frequency s [-].
Complex shear_fluid_ratio(const SaturatedSoil& soil, Complex s);

} // namespace quicksand
