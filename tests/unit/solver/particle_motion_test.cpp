#include "solver/particle_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

TEST(NoiseOfDeformation, FadesByTheShareOfTheStrainAndNotInRigidMotion)
{
    Particles particles;
    resize(particles, 2, false);
    Gradients& L = particles.velocity_gradient_solid;
    L.xy = {3.0, 2.0}; // shear of 3/s; the second only turns
    L.yx = {0.0, -2.0};
    Vectors grid{{1.0, 1.0}, {0.0, 0.0}};
    for (std::size_t p = 0; p < 2; ++p) particles.velocity_solid.set(p, {2.0, -1.0});
    fade_noise_of_deformation(0.1, grid, particles);
    const double rate = 0.1 * 4.0 * 3.0 / std::sqrt(2.0), share = rate / (1.0 + rate);
    EXPECT_NEAR(particles.velocity_solid.x[0], 2.0 - share, 1e-15);
    EXPECT_NEAR(particles.velocity_solid.y[0], -1.0 + share, 1e-15);
    EXPECT_EQ(particles.velocity_solid.x[1], 2.0);
    EXPECT_EQ(particles.velocity_solid.y[1], -1.0);
}

} // namespace
} // namespace quicksand
