#include "solver/deformation_noise.hpp"
#include "solver/particle_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

TEST(NoiseOfDeformation, FadesByTheShareOfTheStrainAndNotInRigidMotion)
{
    Particles particles;
    resize(particles, 3, std::nullopt);
    Gradients& L = particles.velocity_gradient_solid;
    L.xy = {3.0, 3.0, 2.0}; // two with a shear of 3/s; the third only turns
    L.yx = {0.0, 0.0, -2.0};
    const Vectors grid{{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
    particles.velocity_solid = {{2.0, 0.0, 2.0}, {-1.0, 1.0, -1.0}};
    Scalars share;
    fade_noise_of_deformation(0.1, {1.0, 1.0, 1.0}, grid, share, particles);
    const double rate = 0.1 * 4.0 * 3.0 / std::sqrt(2.0), theta = rate / (1.0 + rate);
    EXPECT_NEAR(particles.velocity_solid.x[0], 2.0 - theta, 1e-15);
    EXPECT_NEAR(particles.velocity_solid.y[1], 1.0 - theta, 1e-15);
    EXPECT_EQ(particles.velocity_solid.x[2], 2.0);
    EXPECT_EQ(particles.velocity_solid.y[2], -1.0);
}

TEST(NoiseOfDeformation, KeepsTheMomentumWhereStrainsAndMassesDiffer)
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
    Scalars share;
    fade_noise_of_deformation(0.1, mass, grid, share, particles);
    EXPECT_LT((momentum() - before).norm(), 1e-15 * 10.0);
    EXPECT_LT(particles.velocity_solid.x[0], 1.9);
    EXPECT_EQ(particles.velocity_solid.x[2], 2.0);
}

TEST(CarriedGradients, AreShortenedForLongDomainsOnly)
{
    Particles particles;
    resize(particles, 2, WaterFlow::coupled);
    for (Gradients* L : {&particles.velocity_gradient_solid, &particles.velocity_gradient_fluid}) {
        L->xx = L->xy = L->yx = L->yy = {8.0, 8.0};
    }
    for (std::size_t p = 0; p < 2; ++p) particles.half_edge_1.set(p, {0.5, 0.0});
    particles.half_edge_2.set(0, {0.0, 0.5}); // a cell wide
    particles.half_edge_2.set(1, {1.95, 0.3});
    Problem problem;
    problem.grid.cell_size = 1.0;
    shorten_carried_gradients(problem, particles);
    const double share = 1.0 / (0.25 + 1.95 * 1.95 + 0.3 * 0.3);
    EXPECT_EQ(particles.velocity_gradient_solid.xy[0], 8.0);
    EXPECT_NEAR(particles.velocity_gradient_solid.xy[1], 8.0 * share, 1e-14);
    EXPECT_NEAR(particles.velocity_gradient_fluid.yy[1], 8.0 * share, 1e-14);
}

} // namespace
} // namespace quicksand
