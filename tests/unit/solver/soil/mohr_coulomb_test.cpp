// The Mohr-Coulomb law at a point: the return to every part of the surface against closed forms, invariants
// of random paths, and the stress of known tests.
#include "solver/motion/particle_motion.hpp"
#include "solver/soil/mohr_coulomb.hpp"
#include "solver/soil/mohr_coulomb_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace quicksand {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;

MohrCoulomb silty_sand()
{
    return {10e6, 0.3, 8e3, 32.0 * degree, 7.0 * degree, 5e3};
}

/// How far principal stresses, largest tension first, lie outside the surface, negative inside [Pa].
double yield_excess(const MohrCoulomb& law, const Vector3d& principal)
{
    return MohrCoulombSurface(law).excess(principal[0], principal[2]);
}

/// The principal stresses to which an elastic trial returns, both largest tension first [Pa].
Vector3d return_to_surface(const MohrCoulomb& law, const Vector3d& trial)
{
    return yield_excess(law, trial) > 0.0 ? MohrCoulombSurface(law).return_from(trial) : trial;
}

/// One particle at rest with a stress xx, yy, zz, xy [Pa].
Particles point(double xx, double yy, double zz, double xy)
{
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.stress = {{xx}, {yy}, {zz}, {xy}};
    return particles;
}

void strain(const MohrCoulomb& law, const Eigen::Matrix2d& gradient, Particles& particles)
{
    particles.velocity_gradient_solid = {
        {gradient(0, 0)}, {gradient(0, 1)}, {gradient(1, 0)}, {gradient(1, 1)}};
    update_stress(law, 1.0, 0, 1, particles);
}

/// Principal stresses of a particle, largest tension first.
Vector3d principal(const Particles& particles, std::size_t p = 0)
{
    const SymmetricTensors& s = particles.stress;
    const double centre = 0.5 * (s.xx[p] + s.yy[p]), radius = std::hypot(0.5 * (s.xx[p] - s.yy[p]), s.xy[p]);
    Vector3d sorted(centre + radius, centre - radius, s.zz[p]);
    std::sort(sorted.data(), sorted.data() + 3, std::greater<>());
    return sorted;
}

/// D p for plastic strain p in principal directions [Pa].
Vector3d stiffness_times(const MohrCoulomb& law, const Vector3d& p)
{
    return Vector3d::Constant(lame_modulus(law) * p.sum()) + 2.0 * law.shear_modulus * p;
}

Vector3d shear_flow(const MohrCoulomb& law, int i, int j)
{
    const double sine = std::sin(law.dilation_angle);
    return (1.0 + sine) * Vector3d::Unit(i) - (1.0 - sine) * Vector3d::Unit(j);
}

/// The smallest principal stress that the surface allows beside a largest one.
double least_beside(const MohrCoulomb& law, double largest)
{
    const double s = std::sin(law.friction_angle);
    return ((1.0 + s) * largest - 2.0 * law.cohesion * std::cos(law.friction_angle)) / (1.0 - s);
}

/// A stress on the surface plus D times plastic strain of the planes that hold it: the trial of which it is
/// the return.
struct Part {
    const char* name;
    Vector3d stress;
    Vector3d plastic_strain;
};

std::vector<Part> parts_of_surface(const MohrCoulomb& law)
{
    const double t = law.tension_strength, corner = least_beside(law, t), top = -20e3;
    const double bottom = least_beside(law, top);
    const Vector3d e1 = Vector3d::UnitX(), e2 = Vector3d::UnitY(), e3 = Vector3d::UnitZ();
    const Vector3d s13 = 1e-3 * shear_flow(law, 0, 2), s12 = 4e-4 * shear_flow(law, 0, 1),
                   s23 = 3e-4 * shear_flow(law, 1, 2);
    return {
        {"shear plane", {top, 0.5 * (top + bottom), bottom}, s13},
        {"edge of equal compressions", {top, bottom, bottom}, s13 + s12},
        {"edge of equal extensions", {top, top, bottom}, s13 + s23},
        {"tension plane", {t, 0.6 * t + 0.4 * corner, 0.3 * t + 0.7 * corner}, 1e-3 * e1},
        {"edge of shear and tension", {t, 0.5 * (t + corner), corner}, s13 + 2e-4 * e1},
        {"edge of two tensions", {t, t, 0.5 * (t + corner)}, 1e-3 * e1 + 4e-4 * e2},
        {"corner of one tension", {t, corner, corner}, s13 + s12 + 2e-4 * e1},
        {"corner of two tensions", {t, t, corner}, s13 + s23 + 2e-4 * e1 + 1e-4 * e2},
        {"corner of three tensions", {t, t, t}, 3e-3 * e1 + 2e-3 * e2 + 1e-3 * e3},
    };
}

TEST(MohrCoulomb, ReturnsToEveryPlaneEdgeAndCorner)
{
    const MohrCoulomb law = silty_sand();
    for (const Part& part : parts_of_surface(law)) {
        const Vector3d trial = part.stress + stiffness_times(law, part.plastic_strain);
        ASSERT_GE(trial[0], trial[1]) << part.name;
        ASSERT_GE(trial[1], trial[2]) << part.name;
        EXPECT_LT((return_to_surface(law, trial) - part.stress).norm(), 1e-12 * trial.norm()) << part.name;
    }
}

TEST(MohrCoulomb, ReturnsToTheTipWithoutCutOff)
{
    MohrCoulomb law = silty_sand();
    law.tension_strength = std::numeric_limits<double>::infinity();
    for (const double psi : {0.0, 7.0, 32.0}) {
        law.dilation_angle = psi * degree;
        const Vector3d tip = Vector3d::Constant(surface_tip(law));
        EXPECT_LT((return_to_surface(law, Vector3d(3e6, 2e6, 1e6)) - tip).norm(), 1e-9) << psi;
    }
}

TEST(MohrCoulomb, WithoutFrictionTheStrengthIsTrescas)
{
    const MohrCoulomb clay{5e6, 0.49, 25e3, 0.0, 0.0};
    const Vector3d stress = return_to_surface(clay, Vector3d(9e6, 8.5e6, 8.2e6));
    EXPECT_NEAR(stress[0] - stress[2], 50e3, 1e-7);
    EXPECT_NEAR(stress.sum(), 25.7e6, 1e-6); // flow without change of volume
}

TEST(MohrCoulomb, RandomTrialsReturnToTheSurfaceInOrder)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int trial_number = 0; trial_number < 200'000; ++trial_number) {
        MohrCoulomb law{1e7, 0.499 * unit(random), unit(random) < 0.2 ? 0.0 : 2e4 * unit(random),
                        unit(random) < 0.1 ? 0.0 : 50.0 * degree * unit(random), 0.0};
        if (law.cohesion == 0.0 && law.friction_angle == 0.0) continue;
        law.dilation_angle = unit(random) < 0.3 ? 0.0 : law.friction_angle * unit(random);
        if (unit(random) < 0.6) law.tension_strength = std::min(1e4, surface_tip(law)) * unit(random);
        const double size = std::pow(10.0, 3.0 + 9.0 * unit(random)); // 1 kPa to 1 TPa
        Vector3d trial =
            size * Vector3d(2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0);
        std::sort(trial.data(), trial.data() + 3, std::greater<>());
        const Vector3d stress = return_to_surface(law, trial);
        const double scale = std::max(stress.cwiseAbs().maxCoeff(), law.cohesion);
        ASSERT_LE(yield_excess(law, stress), 1e-9 * scale) << trial.transpose();
        ASSERT_GE(stress[0] - stress[1], -1e-9 * scale) << trial.transpose();
        ASSERT_GE(stress[1] - stress[2], -1e-9 * scale) << trial.transpose();
        // what is lost is plastic strain p = D^-1 (trial - stress), and its work is not negative
        const Vector3d lost = trial - stress;
        const double nu = law.poisson_ratio, E = 2.0 * law.shear_modulus * (1.0 + nu);
        const Vector3d p = ((1.0 + nu) * lost - Vector3d::Constant(nu * lost.sum())) / E;
        const double rounding = 1e-11 * trial.norm() * std::max(trial.norm(), scale) / law.shear_modulus;
        ASSERT_GE(stress.dot(p), -rounding) << trial.transpose() << " to " << stress.transpose();
        if (yield_excess(law, trial) <= 0.0) {
            ASSERT_EQ(stress, trial);
        }
    }
}

TEST(MohrCoulomb, OneDimensionalCompressionOfSandWithoutCohesionStaysElasticAboveActivePressure)
{
    // K0 = nu / (1 - nu) = 0.43 lies above K_a = 0.31, and 0.11 for nu = 0.1 below it
    const double active = (1.0 - std::sin(32.0 * degree)) / (1.0 + std::sin(32.0 * degree));
    for (const double nu : {0.3, 0.1}) {
        const MohrCoulomb law{10e6, nu, 0.0, 32.0 * degree, 0.0};
        Particles particles = point(0.0, 0.0, 0.0, 0.0);
        for (int step = 0; step < 100; ++step)
            strain(law, Eigen::Matrix2d{{0.0, 0.0}, {0.0, -1e-4}}, particles);
        const double ratio = particles.stress.xx[0] / particles.stress.yy[0];
        EXPECT_NEAR(ratio, std::max(nu / (1.0 - nu), active), 1e-9);
        EXPECT_NEAR(particles.stress.zz[0], particles.stress.xx[0], 1e-6);
    }
}

TEST(MohrCoulomb, BiaxialCompressionEndsAtPassivePressure)
{
    // one side pressed in under constant pressure of the other: sigma_1 = N sigma_3 + 2 c sqrt N
    const MohrCoulomb law = silty_sand();
    const double s = std::sin(law.friction_angle), N = (1.0 + s) / (1.0 - s);
    Particles particles = point(-100e3, -100e3, -100e3, 0.0);
    const double M = constrained_modulus(law), elastic = lame_modulus(law) / M;
    for (int step = 0; step < 400; ++step) {
        strain(law, Eigen::Matrix2d{{0.0, 0.0}, {0.0, -1e-4}}, particles);
        for (int i = 0; i < 60; ++i) { // sideways until the pressure there is held
            strain(law, Eigen::Matrix2d{{(-100e3 - particles.stress.xx[0]) / M, 0.0}, {0.0, 0.0}}, particles);
        }
    }
    EXPECT_GT(elastic, 0.0);
    EXPECT_NEAR(-particles.stress.yy[0], N * 100e3 + 2.0 * law.cohesion * std::sqrt(N), 5.0);
}

TEST(MohrCoulomb, PlasticShearDilatesBySinPsi)
{
    // far into flow: plastic volume over greatest plastic shear strain is sin psi
    for (const double psi : {0.0, 7.0, 20.0}) {
        MohrCoulomb law = silty_sand();
        law.dilation_angle = psi * degree;
        Particles particles = point(-100e3, -100e3, -100e3, 0.0);
        const double G = law.shear_modulus, lambda = lame_modulus(law);
        for (int step = 0; step < 200; ++step) {
            const SymmetricTensors before = particles.stress;
            strain(law, Eigen::Matrix2d{{0.0, 1e-4}, {0.0, 0.0}}, particles);
            if (step < 100) continue;
            const double xx = particles.stress.xx[0] - before.xx[0],
                         yy = particles.stress.yy[0] - before.yy[0],
                         zz = particles.stress.zz[0] - before.zz[0],
                         xy = particles.stress.xy[0] - before.xy[0];
            const double volume = -(xx + yy + zz) / (3.0 * lambda + 2.0 * G);
            const double shear = std::hypot((xx - yy) / (2.0 * G), 1e-4 - xy / G);
            EXPECT_NEAR(volume / shear, std::sin(law.dilation_angle), 1e-9);
        }
    }
}

TEST(MohrCoulomb, TensionIsCutOff)
{
    const MohrCoulomb law = silty_sand();
    Particles particles = point(-10e3, -10e3, -10e3, 0.0);
    for (int step = 0; step < 50; ++step) strain(law, Eigen::Matrix2d{{0.0, 0.0}, {0.0, 1e-4}}, particles);
    EXPECT_NEAR(particles.stress.yy[0], law.tension_strength, 1e-9);
    EXPECT_LE(principal(particles)[0], law.tension_strength + 1e-9);
}

TEST(MohrCoulomb, ProportionalStrainMayBeSubdivided)
{
    // from a stress without deviator, the plastic part of a proportional path lies on one plane: one step or
    // many
    const MohrCoulomb law = silty_sand();
    const Eigen::Matrix2d whole{{4e-3, 0.0}, {0.0, -1e-2}};
    Particles once = point(-50e3, -50e3, -50e3, 0.0), often = once;
    strain(law, whole, once);
    for (int step = 0; step < 1000; ++step) strain(law, 1e-3 * whole, often);
    EXPECT_LT((principal(once) - principal(often)).norm(), 1e-9 * principal(once).norm());
}

TEST(MohrCoulomb, AnswersAlikeInEveryFrame)
{
    // the same strain seen in a turned frame gives the turned stress
    const MohrCoulomb law = silty_sand();
    const Eigen::Matrix2d strain_rate{{2e-3, 1e-3}, {1e-3, -4e-3}}, stress{{-60e3, 10e3}, {10e3, -90e3}};
    Particles straight = point(stress(0, 0), stress(1, 1), -70e3, stress(0, 1));
    strain(law, strain_rate, straight);
    const Eigen::Matrix2d Q = Eigen::Rotation2D<double>(0.7).toRotationMatrix();
    const Eigen::Matrix2d turned = Q * stress * Q.transpose();
    Particles slanted = point(turned(0, 0), turned(1, 1), -70e3, turned(0, 1));
    strain(law, Q * strain_rate * Q.transpose(), slanted);
    const SymmetricTensors& s = straight.stress;
    const Eigen::Matrix2d expected =
        Q * Eigen::Matrix2d{{s.xx[0], s.xy[0]}, {s.xy[0], s.yy[0]}} * Q.transpose();
    EXPECT_NEAR(slanted.stress.xx[0], expected(0, 0), 1e-8);
    EXPECT_NEAR(slanted.stress.yy[0], expected(1, 1), 1e-8);
    EXPECT_NEAR(slanted.stress.xy[0], expected(0, 1), 1e-8);
    EXPECT_NEAR(slanted.stress.zz[0], s.zz[0], 1e-8);
}

TEST(MohrCoulomb, ATurnOfTheBodyTurnsItsYieldStress)
{
    // a stress on the surface, turned by the engine in 500 steps without strain: on the surface, unchanged
    Problem problem;
    problem.materials = {Material{"sand", silty_sand()}};
    const double top = -20e3, bottom = least_beside(silty_sand(), top);
    Particles particles = point(bottom, top, top, 0.0);
    particles.velocity_gradient_solid = {{0.0}, {-1.0}, {1.0}, {0.0}};
    for (int step = 0; step < 500; ++step) update_effective_stress(problem, 2e-3, particles);
    EXPECT_LT((principal(particles) - Vector3d(top, top, bottom)).norm(), 1e-9 * std::abs(bottom));
    const double angle = 500.0 * 2.0 * std::atan(1e-3);
    EXPECT_NEAR(particles.stress.xx[0],
                bottom * std::pow(std::cos(angle), 2) + top * std::pow(std::sin(angle), 2), 1e-6);
}

TEST(MohrCoulomb, ReducedStrengthDividesCohesionAndTangent)
{
    const MohrCoulomb law = silty_sand(), weaker = reduced(law, 1.6);
    EXPECT_DOUBLE_EQ(weaker.cohesion, law.cohesion / 1.6);
    EXPECT_NEAR(std::tan(weaker.friction_angle), std::tan(law.friction_angle) / 1.6, 1e-15);
    EXPECT_EQ(weaker.dilation_angle, law.dilation_angle);
    EXPECT_NEAR(surface_tip(weaker), surface_tip(law), 1e-9);
    EXPECT_EQ(reduced(law, 10.0).dilation_angle, reduced(law, 10.0).friction_angle);
}

TEST(MohrCoulomb, ElasticParticlesAreLeftToElasticity)
{
    MohrCoulomb law = silty_sand();
    Particles particles = point(-100e3, -120e3, -100e3, 5e3), elastic = particles;
    const Eigen::Matrix2d small{{1e-5, 2e-5}, {0.0, -3e-5}};
    strain(law, small, particles);
    law.cohesion = 1e12;
    law.tension_strength = 1e12;
    strain(law, small, elastic);
    EXPECT_EQ(particles.stress.xx[0], elastic.stress.xx[0]);
    EXPECT_EQ(particles.stress.xy[0], elastic.stress.xy[0]);
}

} // namespace
} // namespace quicksand
