#include "solver/verification/solutions/shear_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

ShearBeam beam_of(double shear_modulus, double damping_ratio)
{
    ShearBeam beam;
    beam.soil.shear_modulus = shear_modulus;
    beam.height = 0.3175;
    beam.damping_ratio = damping_ratio;
    return beam;
}

double amplification(const ShearBeam& beam, double frequency)
{
    return std::abs(shear_transfer(beam, beam.height, frequency));
}

/// The same of one body of the mass density rho [kg/m3], the limit in which nothing moves in it.
double amplification_of_one_body(const ShearBeam& beam, double density, double frequency)
{
    const double omega = 2.0 * std::numbers::pi * frequency;
    const Complex G = beam.soil.shear_modulus * Complex(1.0, 2.0 * beam.damping_ratio);
    return 1.0 / std::abs(std::cos(omega * std::sqrt(density / G) * beam.height));
}

TEST(ShearBeam, AmplificationIsPublished)
{
    const double table[][3] = {{20e6, 50.0, 1.79913},  {20e6, 100.0, 2.59573},  {20e6, 180.0, 1.07829},
                               {100e6, 50.0, 1.10476}, {100e6, 100.0, 1.56539}, {100e6, 180.0, 26.58507}};
    for (const auto& [G, f, ratio] : table) EXPECT_NEAR(amplification(beam_of(G, 0.02), f), ratio, 5e-6);
    const ShearBeam stiff = beam_of(100e6, 0.02);
    EXPECT_NEAR(amplification_of_one_body(stiff, stiff.soil.density(), 180.0), 30.146, 5e-4);
}

TEST(ShearBeam, MeetsTheWaveEquationAndItsBoundaries)
{
    const ShearBeam beam = beam_of(20e6, 0.02);
    const double omega = 2.0 * std::numbers::pi * 100.0, d = 1e-4, C = beam.soil.drag();
    const Complex G = 20e6 * Complex(1.0, 0.04), s(0.0, omega);
    const auto u = [&](double x) { return shear_transfer(beam, x, 100.0); };
    for (const double x : {0.05, 0.2}) {
        // r_2 s^2 u_w = C s (u_s - u_w) and r_1 s^2 u_s + r_2 s^2 u_w = G u_s''
        const Complex u_w = u(x) * C / (C + s * beam.soil.partial_density_fluid());
        const Complex inertia =
            s * s * (beam.soil.partial_density_solid() * u(x) + beam.soil.partial_density_fluid() * u_w);
        const Complex force = G * (u(x + d) - 2.0 * u(x) + u(x - d)) / (d * d);
        EXPECT_LT(std::abs(force / inertia - 1.0), 1e-5);
    }
    EXPECT_LT(std::abs(u(0.0) - 1.0), 1e-14);
    EXPECT_LT(std::abs(u(0.3175 + d) - u(0.3175 - d)), 1e-12); // no shear stress at the top
}

TEST(ShearBeam, LimitsOfDragAndFrequency)
{
    ShearBeam tight = beam_of(100e6, 0.02), open = tight;
    const double mixture = tight.soil.density(), grains = tight.soil.partial_density_solid();
    tight.soil.hydraulic_conductivity = 1e-10;
    EXPECT_NEAR(amplification(tight, 180.0), amplification_of_one_body(tight, mixture, 180.0), 1e-4);
    open.soil.hydraulic_conductivity = 1e4;
    EXPECT_NEAR(amplification(open, 180.0), amplification_of_one_body(open, grains, 180.0), 1e-4);
    EXPECT_NEAR(amplification(tight, 1e-3), 1.0, 1e-9);
    // near resonance a lightly damped layer amplifies by 4 / (pi 2 D)
    const double f1 = std::sqrt(tight.soil.shear_modulus / mixture) / (4.0 * tight.height);
    EXPECT_NEAR(amplification(tight, f1), 2.0 / (std::numbers::pi * 0.02), 0.05);
}

} // namespace
} // namespace quicksand
