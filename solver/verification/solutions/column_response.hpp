// A saturated column between rollers on a fixed impervious base, drained at its top and loaded there: its
// response at a complex frequency s, in the linear theory of small strains. s = i omega is harmonic motion;
// over all s it is the Laplace transform of a column that starts at rest.
#pragma once

#include "solver/verification/solutions/biot_dispersion.hpp"

namespace quicksand {

/// Amplitudes at a point per unit of load: displacements positive upward [m/Pa], pressure compression
/// positive [-].
struct ColumnAmplitude {
    Complex displacement_solid, displacement_fluid, pore_pressure;
};

/// Sum of the fast and the slow wave that meets the two conditions at the top: the load presses on the
/// skeleton, the pressure is zero.
class ColumnResponse {
public:
    ColumnResponse(const SaturatedSoil& soil, double height, Complex s);

    /// At a height x above the base [m].
    ColumnAmplitude amplitude(double x) const;

private:
    double height_ = 0.0;
    double storage_modulus_ = 0.0;
    std::array<Complex, 2> kappa_;         // [1/m], Re kappa >= 0
    std::array<Eigen::Vector2cd, 2> mode_; // strain of (solid, fluid) at the top per load [1/Pa]
    std::array<Complex, 2> outflow_;       // (1-n) eps_s + n eps_w of a mode [1/Pa]
};

} // namespace quicksand
