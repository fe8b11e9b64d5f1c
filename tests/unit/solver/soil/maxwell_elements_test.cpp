// Damping by Maxwell elements at a point: the loss of harmonic strains over the band of frequencies, the
// stiffness at its middle and its ends, long steps, turned strains, and steady plastic flow.
#include "solver/motion/particle_motion.hpp"
#include "solver/soil/linear_elastic.hpp"
#include "solver/soil/maxwell_elements.hpp"
#include "solver/soil/mohr_coulomb.hpp"
#include "solver/soil/mohr_coulomb_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

namespace quicksand {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// G 10 MPa, nu 0.3, damped around 3 Hz.
LinearElastic damped_soil(double damping_ratio)
{
    return {10e6, 0.3, damping_ratio, 3.0};
}

template <class Law>
Particles point_with_memory(const Law& law)
{
    Particles point;
    resize(point, 1, std::nullopt);
    add_memory(point, memory_of(law).size());
    return point;
}

template <class Law>
void strain_point(const Law& law, const Eigen::Matrix2d& rate, double dt, Particles& point)
{
    point.velocity_gradient_solid = {{rate(0, 0)}, {rate(0, 1)}, {rate(1, 0)}, {rate(1, 1)}};
    update_stress(law, dt, 0, 1, point);
}

Eigen::Matrix2d stress_of(const Particles& point)
{
    Eigen::Matrix2d s;
    s << point.stress.xx[0], point.stress.xy[0], point.stress.xy[0], point.stress.yy[0];
    return s;
}

/// Stress over strain in the last of many cycles of the strain `direction` cos(2 pi f t), as a number of the
/// complex plane, for the part that the strain works on [Pa].
std::complex<double> complex_stiffness(const LinearElastic& law, const Eigen::Matrix2d& direction, double f)
{
    constexpr int steps = 400;
    const int cycles = 4 + static_cast<int>(4.0 * f); // the slowest element has forgotten the start
    Particles point = point_with_memory(law);
    const double dt = 1.0 / (f * steps);
    std::complex<double> sum = 0.0;
    const auto strain_at = [&](int k) { return 1e-5 * std::cos(turn * k / steps); };
    for (int k = 0; k < cycles * steps; ++k) {
        strain_point(law, (strain_at(k + 1) - strain_at(k)) / dt * direction, dt, point);
        if (k < (cycles - 1) * steps) continue;
        const double part = stress_of(point).cwiseProduct(direction).sum() / direction.squaredNorm();
        sum += part * std::polar(1.0, -turn * (k + 1) / steps);
    }
    return sum / (0.5 * steps * 1e-5);
}

Eigen::Matrix2d shear_strain()
{
    return (Eigen::Matrix2d() << 0.0, 0.5, 0.5, 0.0).finished();
}

TEST(MaxwellElements, DampingIsThatAskedForOverABandOfOneToForty)
{
    for (const double ratio : {0.005, 0.02, 0.05, 0.2}) {
        const double within = ratio > 0.05 ? 0.15 : 0.05;
        for (const double f : {0.475, 0.8, 1.4, 3.0, 6.0, 11.0, 19.0}) {
            const auto stiffness = complex_stiffness(damped_soil(ratio), shear_strain(), f);
            const double loss = 0.5 * stiffness.imag() / stiffness.real();
            EXPECT_GE(loss, (1.0 - within) * ratio) << f << " Hz";
            EXPECT_LE(loss, (1.0 + within) * ratio) << f << " Hz";
        }
    }
}

TEST(MaxwellElements, StiffnessAtTheMiddleOfTheBandIsThatWithoutDamping)
{
    for (const double ratio : {0.02, 0.05}) {
        const LinearElastic law = damped_soil(ratio);
        const auto shear = complex_stiffness(law, shear_strain(), 3.0);
        EXPECT_NEAR(shear.real(), 2.0 * law.shear_modulus, 2e-4 * law.shear_modulus);
        const auto compression = complex_stiffness(law, Eigen::Matrix2d::Identity(), 3.0);
        const double bulk = 2.0 * (lame_modulus(law) + law.shear_modulus); // of both directions together
        EXPECT_NEAR(compression.real(), bulk, 2e-4 * bulk);
        EXPECT_NEAR(0.5 * compression.imag() / compression.real(), 0.5 * shear.imag() / shear.real(), 1e-9);
    }
}

TEST(MaxwellElements, NoVibrationMeetsMoreThanTheUnrelaxedStiffness)
{
    const LinearElastic law = damped_soil(0.05);
    const double unrelaxed = unrelaxed_stiffness(law);
    EXPECT_NEAR(unrelaxed, 1.24, 0.02);
    EXPECT_NEAR(std::abs(complex_stiffness(law, shear_strain(), 2000.0)), 2.0 * unrelaxed * law.shear_modulus,
                2e-3 * law.shear_modulus);
    EXPECT_DOUBLE_EQ(particle_moduli(law, 0, 1, Particles{}).stiffest, constrained_modulus(law) * unrelaxed);
    EXPECT_EQ(unrelaxed_stiffness(damped_soil(0.0)), 1.0);
}

TEST(MaxwellElements, StrainOfOneStepIsThatOfManyShortOnes)
{
    const LinearElastic law = damped_soil(0.05);
    const Eigen::Matrix2d rate = (Eigen::Matrix2d() << 1e-4, 3e-4, -1e-4, 2e-4).finished();
    Particles once = point_with_memory(law), often = once;
    strain_point(law, rate, 0.5, once);
    for (int k = 0; k < 1000; ++k) strain_point(law, rate, 0.5e-3, often);
    EXPECT_NEAR((stress_of(once) - stress_of(often)).norm(), 0.0, 1e-10 * stress_of(once).norm());
    EXPECT_NEAR(once.stress.zz[0], often.stress.zz[0], 1e-10 * std::abs(once.stress.zz[0]));
}

TEST(MaxwellElements, SteadyPlasticFlowLeavesThemWithoutStress)
{
    MohrCoulomb law{10e6, 0.3, 5e3, 0.5, 0.0};
    law.damping_ratio = 0.05;
    Particles point = point_with_memory(law);
    for (Scalars* part : {&point.stress.xx, &point.stress.yy, &point.stress.zz}) (*part)[0] = -50e3;
    double largest = 0.0;
    for (int k = 0; k < 20000; ++k) {
        strain_point(law, 1e-2 * shear_strain(), 1e-3, point);
        if (k == 100) largest = std::abs(point.memory[2][0]);
    }
    const Eigen::Matrix2d s = stress_of(point);
    const double radius = std::hypot(0.5 * (s(0, 0) - s(1, 1)), s(0, 1)), centre = 0.5 * s.trace();
    EXPECT_NEAR(radius, 5e3 * std::cos(0.5) - centre * std::sin(0.5), 1.0);
    EXPECT_GT(largest, 100.0);
    EXPECT_LT(std::abs(point.memory[2][0]), 1e-3 * largest);
}

// In large strain the stress of an element turns with its particle, as the whole stress does.
TEST(MaxwellElements, TurnWithTheirParticle)
{
    Problem problem;
    problem.materials.resize(1);
    problem.materials[0].law = damped_soil(0.05);
    Particles point = point_with_memory(problem.materials[0].law);
    point.material = {0};
    point.stress = {{-30e3}, {-70e3}, {-40e3}, {12e3}};
    const auto part_of_stress = [&]() -> Eigen::Matrix2d { return 0.1 * stress_of(point); };
    const Eigen::Matrix2d before = part_of_stress();
    point.memory[1][0] = 0.5 * (before(0, 0) - before(1, 1));
    point.memory[2][0] = before(0, 1);
    constexpr int steps = 200;
    constexpr double angle = 1.1, dt = 1e-9; // no time to relax [rad], [s]
    point.velocity_gradient_solid = {{0.0}, {-angle / steps / dt}, {angle / steps / dt}, {0.0}};
    for (int k = 0; k < steps; ++k) update_effective_stress(problem, dt, point);
    const Eigen::Matrix2d after = part_of_stress();
    EXPECT_GT((after - before).norm(), 1e3);
    EXPECT_NEAR(point.memory[1][0], 0.5 * (after(0, 0) - after(1, 1)), 0.1);
    EXPECT_NEAR(point.memory[2][0], after(0, 1), 0.1);
}

TEST(MaxwellElements, SoilWithoutDampingRemembersNothing)
{
    EXPECT_TRUE(memory_of(damped_soil(0.0)).empty());
    EXPECT_EQ(undamped(damped_soil(0.02)), (LinearElastic{10e6, 0.3, 0.0, 3.0}));
}

} // namespace
} // namespace quicksand
