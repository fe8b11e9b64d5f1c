#include "solver/motion/null_space_damping.hpp"
#include "solver/motion/particle_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

TEST(NullSpaceOfDeformation, DecaysWithTheStrainAndNotInRigidMotion)
{
    Particles particles;
    resize(particles, 3, std::nullopt);
    Gradients& L = particles.velocity_gradient_solid;
    L.xy = {3.0, 3.0, 2.0}; // two with a shear of 3/s; the third only turns
    L.yx = {0.0, 0.0, -2.0};
    const Vectors grid{{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
    particles.velocity_solid = {{2.0, 0.0, 2.0}, {-1.0, 1.0, -1.0}};
    Scalars fraction;
    damp_null_space_of_deformation(0.1, {1.0, 1.0, 1.0}, grid, fraction, particles);
    const double rate = 0.1 * 4.0 * 3.0 / std::sqrt(2.0), theta = rate / (1.0 + rate);
    EXPECT_NEAR(particles.velocity_solid.x[0], 2.0 - theta, 1e-15);
    EXPECT_NEAR(particles.velocity_solid.y[1], 1.0 - theta, 1e-15);
    EXPECT_EQ(particles.velocity_solid.x[2], 2.0);
    EXPECT_EQ(particles.velocity_solid.y[2], -1.0);
}

TEST(NullSpaceOfDeformation, KeepsTheMomentumWhereStrainsAndMassesDiffer)
{
    Particles particles;
    resize(particles, 3, std::nullopt);
    particles.velocity_gradient_solid.xx = {3.0, 0.5, 0.0};
    const Vectors grid{{1.0, 1.0, 1.0}, {0.0, 0.5, 0.0}};
    particles.velocity_solid = {{2.0, 0.3, 2.0}, {-1.0, 1.0, -1.0}};
    const Scalars mass = {2.0, 5.0, 1.0};
    const auto momentum = [&] {
        Vector2 sum = Vector2::Zero();
        for (std::size_t p = 0; p < 3; ++p) sum += mass[p] * particles.velocity_solid[p];
        return sum;
    };
    const Vector2 before = momentum();
    Scalars fraction;
    damp_null_space_of_deformation(0.1, mass, grid, fraction, particles);
    EXPECT_LT((momentum() - before).norm(), 1e-15 * 10.0);
    EXPECT_LT(particles.velocity_solid.x[0], 1.9);
    EXPECT_EQ(particles.velocity_solid.x[2], 2.0);
}

} // namespace
} // namespace quicksand
