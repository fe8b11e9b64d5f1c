#include "solver/verification/solutions/shear_beam.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {

Complex shear_transfer(const ShearBeam& beam, double x, double frequency)
{
    const double omega = 2.0 * std::numbers::pi * frequency;
    const Complex G = beam.soil.shear_modulus * Complex(1.0, 2.0 * beam.damping_ratio);
    const Complex xi = std::sqrt(shear_wave_number_squared(beam.soil, Complex(0.0, omega), G));
    return std::cos(xi * (beam.height - x)) / std::cos(xi * beam.height);
}

} // namespace quicksand
