#include "solver/verification/solutions/biot_dispersion.hpp"
#include "solver/verification/solutions/eigenmodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

SaturatedSoil soil_with(double conductivity)
{
    SaturatedSoil soil;
    soil.hydraulic_conductivity = conductivity;
    return soil;
}

double omega_of(double frequency)
{
    return 2.0 * std::numbers::pi * frequency;
}

/// Complex wave numbers xi of travelling waves e^{i(omega t - xi x)}, Im xi <= 0 [1/m].
struct WaveNumbers {
    Complex fast, slow, shear;
};

Complex decaying(Complex wave_number_squared)
{
    const Complex xi = std::sqrt(wave_number_squared);
    return xi.imag() > 0.0 ? -xi : xi;
}

WaveNumbers wave_numbers(const SaturatedSoil& soil, double angular_frequency)
{
    const Complex s(0.0, angular_frequency);
    const auto waves = longitudinal_waves(soil, s);
    return {decaying(-waves[0].kappa_squared), decaying(-waves[1].kappa_squared),
            decaying(shear_wave_number_squared(soil, s, soil.shear_modulus))};
}

/// omega / Re xi [m/s].
double phase_speed(Complex wave_number, double angular_frequency)
{
    return angular_frequency / wave_number.real();
}

/// 1/Q = -Im xi^2 / Re xi^2 [-]; twice the damping ratio where it is small.
double inverse_quality_factor(Complex wave_number)
{
    const Complex squared = wave_number * wave_number;
    return -squared.imag() / squared.real();
}

/// Rates of a standing wave's state (w u_s, w u_w, v_s, v_w); a frequency w near the roots makes the entries
/// of like size. The stiffness has the wave number in it.
Eigen::Matrix4d state_matrix(const SaturatedSoil& soil, const Eigen::Matrix2d& stiffness, double w)
{
    const Eigen::Vector2d mass(soil.partial_density_solid(), soil.partial_density_fluid());
    Eigen::Matrix2d J;
    J << 1.0, -1.0, -1.0, 1.0;
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    A.topRightCorner<2, 2>() = w * Eigen::Matrix2d::Identity();
    A.bottomLeftCorner<2, 2>() = -(mass.cwiseInverse().asDiagonal() * stiffness) / w;
    A.bottomRightCorner<2, 2>() = -soil.drag() * (mass.cwiseInverse().asDiagonal() * J);
    return A;
}

/// Distance of a root from the nearest eigenvalue, over its size.
double distance(const Eigen::VectorXcd& eigenvalues, Complex root)
{
    return (eigenvalues.array() - root).abs().minCoeff() / std::abs(root);
}

TEST(BiotDispersion, PhaseSpeedsArePublished)
{
    const SaturatedSoil soil;
    for (const double f : {1.0, 50.0}) {
        const WaveNumbers waves = wave_numbers(soil, omega_of(f));
        EXPECT_NEAR(phase_speed(waves.fast, omega_of(f)), 1678.4, 0.05);
    }
    EXPECT_NEAR(phase_speed(wave_numbers(soil, omega_of(180)).fast, omega_of(180)), 1678.45, 0.005);
    EXPECT_NEAR(phase_speed(wave_numbers(soil, omega_of(1e4)).fast, omega_of(1e4)), 1773.8, 0.05);
    EXPECT_NEAR(phase_speed(wave_numbers(soil, omega_of(50)).slow, omega_of(50)), 45.65, 0.005);
    EXPECT_NEAR(undragged_speeds(soil).fast, 1838.9, 0.05);
    EXPECT_NEAR(undragged_speeds(soil).slow, 388.0, 0.5);
}

TEST(BiotDispersion, ShearDampingByDragIsPublished)
{
    EXPECT_NEAR(inverse_quality_factor(wave_numbers(soil_with(1e-4), omega_of(50)).shear), 1.65e-3, 5e-6);
    EXPECT_NEAR(inverse_quality_factor(wave_numbers(soil_with(1e-2), omega_of(50)).shear), 0.115, 5e-4);
}

TEST(BiotDispersion, WaveNumbersMeetThePolynomialOfTheirDeterminant)
{
    for (const double k : {1e-1, 1e-3, 1e-5, 1e-7}) {
        const SaturatedSoil soil = soil_with(k);
        const Eigen::Matrix2d K = soil.longitudinal_stiffness();
        const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid();
        for (const double w : {1.0, 1e3, 1e5}) {
            const WaveNumbers waves = wave_numbers(soil, w);
            const Complex drag(0.0, soil.drag() / w);
            for (const Complex xi : {waves.fast, waves.slow}) {
                EXPECT_LE(xi.imag(), 0.0);
                const Complex y = xi * xi;
                const Complex terms[3] = {
                    soil.porosity * soil.constrained_modulus * soil.water_bulk_modulus * y * y,
                    -y * w * w * (K(0, 0) * r2 + K(1, 1) * r1 - drag * soil.undrained_modulus()),
                    w * w * w * w * (r1 * r2 - drag * soil.density())};
                EXPECT_LT(std::abs(terms[0] + terms[1] + terms[2]), 1e-12 * std::abs(terms[1]));
            }
        }
    }
}

TEST(BiotDispersion, LowFrequenciesAreUndrainedWaveAndConsolidation)
{
    const SaturatedSoil soil = soil_with(1e-6);
    const double w = 1.0;
    const WaveNumbers waves = wave_numbers(soil, w);
    EXPECT_NEAR(phase_speed(waves.fast, w), std::sqrt(soil.undrained_modulus() / soil.density()), 1e-3);
    const Complex consolidation(0.0, -w / soil.consolidation_coefficient());
    EXPECT_LT(std::abs(waves.slow * waves.slow / consolidation - 1.0), 1e-4);
    // the amplitude of diffusion falls by e over its wave length / 2 pi
    EXPECT_NEAR(-waves.slow.imag() / waves.slow.real(), 1.0, 1e-4);
    EXPECT_NEAR(phase_speed(waves.shear, w), std::sqrt(soil.shear_modulus / soil.density()), 1e-4);
}

TEST(BiotDispersion, HighFrequenciesLoseTheDrag)
{
    const SaturatedSoil soil;
    const UndraggedSpeeds limits = undragged_speeds(soil);
    const double w = omega_of(1e7);
    const WaveNumbers waves = wave_numbers(soil, w);
    EXPECT_NEAR(phase_speed(waves.fast, w) / limits.fast, 1.0, 1e-5);
    EXPECT_NEAR(phase_speed(waves.slow, w) / limits.slow, 1.0, 1e-5);
    EXPECT_NEAR(phase_speed(waves.shear, w) / limits.shear, 1.0, 1e-5);
}

TEST(BiotDispersion, StandingModesAreEigenvaluesOfTheEquationsOfMotion)
{
    for (const double k : {1e-1, 1e-2, 1e-3, 1e-4}) {
        const SaturatedSoil soil = soil_with(k);
        for (const double xi : {1.0, 10.0, 300.0}) {
            const double w = 1e3 * xi;
            const Eigen::Matrix4d A = state_matrix(soil, xi * xi * soil.longitudinal_stiffness(), w);
            const Eigen::VectorXcd found = eigenvalues(A.cast<Complex>());
            const LongitudinalModes modes = longitudinal_modes(soil, xi);
            for (const Complex s : {modes.fast, modes.slow, modes.relative})
                EXPECT_LT(distance(found, s), 1e-8) << k << " " << xi;
            Eigen::Matrix2d shear_stiffness = Eigen::Matrix2d::Zero();
            shear_stiffness(0, 0) = soil.shear_modulus * xi * xi;
            const Eigen::Matrix4d B = state_matrix(soil, shear_stiffness, w);
            const ShearModes shear = shear_modes(soil, xi);
            EXPECT_LT(distance(eigenvalues(B.cast<Complex>()), shear.shear), 1e-8);
            EXPECT_LT(distance(eigenvalues(B.cast<Complex>()), shear.relative), 1e-8);
            const Complex fraction = shear_fluid_ratio(soil, shear.shear);
            const Eigen::Vector4cd state(w, w * fraction, shear.shear, shear.shear * fraction);
            EXPECT_LT((B * state - shear.shear * state).norm(), 1e-8 * B.norm() * state.norm());
        }
    }
}

TEST(BiotDispersion, SlowModeOfTightSoilIsConsolidation)
{
    for (const double k : {1e-5, 1e-7, 1e-9}) {
        const SaturatedSoil soil = soil_with(k);
        const LongitudinalModes modes = longitudinal_modes(soil, 10.0);
        EXPECT_NEAR(modes.slow.real() / (-soil.consolidation_coefficient() * 100.0), 1.0, 1e-4);
        EXPECT_EQ(modes.slow.imag(), 0.0);
        EXPECT_NEAR(modes.fast.imag() / 10.0, 1678.4, 0.5);
        const double stop =
            soil.drag() * soil.density() / (soil.partial_density_solid() * soil.partial_density_fluid());
        EXPECT_NEAR(modes.relative.real() / -stop, 1.0, 1e-2);
    }
}

TEST(BiotDispersion, SlowWaveTravelsInOpenSoil)
{
    const LongitudinalModes modes = longitudinal_modes(soil_with(1e-1), 10.0);
    EXPECT_NEAR(modes.slow.imag() / 10.0, 388.27, 0.05);
    EXPECT_EQ(modes.slow, std::conj(modes.relative));
}

} // namespace
} // namespace quicksand
