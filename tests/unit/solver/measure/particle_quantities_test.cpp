#include "solver/interpolation/cpdi2.hpp"
#include "solver/measure/particle_quantities.hpp"
#include "solver/measure/quantities.hpp"
#include "solver/problem/solid_mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

TEST(ParticleQuantities, ShearStrainIsGammaInSimpleShear)
{
    Eigen::Matrix2d gradient;
    gradient << 1.0, 0.3, 0.0, 1.0;
    EXPECT_NEAR(greatest_shear_strain(gradient), 0.3, 1e-15);
}

TEST(ParticleQuantities, ShearStrainIgnoresRotationAndSwelling)
{
    const double angle = 0.7;
    Eigen::Matrix2d rotation;
    rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    EXPECT_NEAR(greatest_shear_strain(1.2 * rotation), 0.0, 1e-15);
}

TEST(ParticleQuantities, ShearStrainFollowsTheSingularValues)
{
    Eigen::Matrix2d gradient;
    gradient << 1.2, 0.0, 0.0, 0.8;
    EXPECT_NEAR(greatest_shear_strain(gradient), 0.4 / std::sqrt(0.96), 1e-15);
}

TEST(ParticleQuantities, StrainsOfSmallStrainAreThoseOfTheLinearTensor)
{
    // 1.5 along x, -1.2 along y: the gradient turns the particle inside out
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.reference_edge_1.set(0, {0.5, 0.0});
    particles.reference_edge_2.set(0, {0.0, 0.25});
    particles.half_edge_1.set(0, {1.25, 0.0});
    particles.half_edge_2.set(0, {0.1, -0.05});
    Problem problem;
    problem.strain = StrainForm::small;
    EXPECT_NEAR(greatest_shear_strain(problem, particles, 0), std::hypot(2.7, 0.4), 1e-15);
    EXPECT_NEAR(volumetric_strain(problem, particles, 0), 0.3, 1e-15);
    EXPECT_NEAR(largest_strain(problem, particles), std::hypot(2.7, 0.4), 1e-15);
    problem.strain = StrainForm::large;
    EXPECT_NEAR(volumetric_strain(problem, particles, 0), -0.5 - 1.0, 1e-15);
}

TEST(ParticleQuantities, StressMeasuresOfAKnownTensor)
{
    const SymmetricTensors stress{{-100.0}, {-200.0}, {-120.0}, {30.0}};
    EXPECT_DOUBLE_EQ(mean_effective_stress(stress, 0), 140.0);
    // q^2 = ((xx-yy)^2 + (yy-zz)^2 + (zz-xx)^2)/2 + 3 xy^2
    EXPECT_NEAR(deviatoric_stress(stress, 0), std::sqrt(0.5 * (1e4 + 6.4e3 + 4e2) + 2700.0), 1e-12);
}

TEST(ParticleQuantities, CornersGoCounterClockwiseFromTheLowerLeft)
{
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.position.set(0, {1.0, 2.0});
    particles.half_edge_1.set(0, {0.5, 0.0});
    particles.half_edge_2.set(0, {0.1, 0.25});
    const auto outline = quadrilateral_corners(particles, 0);
    EXPECT_EQ(outline[0], Vector2(0.4, 1.75));
    EXPECT_EQ(outline[1], Vector2(1.4, 1.75));
    EXPECT_EQ(outline[2], Vector2(1.6, 2.25));
    EXPECT_EQ(outline[3], Vector2(0.6, 2.25));
}

TEST(ParticleQuantities, RuIsUndefinedUnderHardlyAnyStress)
{
    Particles particles;
    resize(particles, 2, WaterFlow::coupled);
    particles.pore_pressure = {50.0, 50.0};
    particles.initial_vertical_effective_stress = {100.0, 0.5};
    Problem problem;
    problem.materials.resize(2);
    EXPECT_EQ(excess_pressure_ratio(problem, particles, 0), 0.5);
    EXPECT_TRUE(std::isnan(excess_pressure_ratio(problem, particles, 1)));
    make_solid(2400.0, Water{}, problem.materials[1]);
    particles.material[0] = 1;
    EXPECT_TRUE(std::isnan(excess_pressure_ratio(problem, particles, 0))) << "a solid has no ru";
    particles.porosity = {0.2, 0.4};
    const Quantity& porosity = quantity_named("porosity");
    EXPECT_EQ(porosity.value(problem, particles, 0)[0], 0.0) << "nor pores";
    particles.material[1] = 0;
    EXPECT_EQ(porosity.value(problem, particles, 1)[0], 0.4);
}

} // namespace quicksand
