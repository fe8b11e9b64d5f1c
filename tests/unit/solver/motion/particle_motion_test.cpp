#include "solver/motion/null_space_damping.hpp"
#include "solver/motion/particle_motion.hpp"
#include "solver/water/pore_pressure.hpp"

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

/// The gradient over x_n of the motion of a body that turns by `angle` in a step of length dt, as leapfrog
/// has it: x_n+1 = R x_n, L = (R - I)/dt.
Gradients gradient_of_turn(double angle, double dt)
{
    const double c = (std::cos(angle) - 1.0) / dt, s = std::sin(angle) / dt;
    return {{c}, {-s}, {s}, {c}};
}

TEST(GradientsOfTheMiddle, HaveNoStrainInATurn)
{
    for (const double angle : {1e-3, 0.1, 1.0}) {
        constexpr double dt = 0.01;
        Particles particles;
        resize(particles, 1, std::nullopt);
        Gradients& L = particles.velocity_gradient_solid;
        L = gradient_of_turn(angle, dt);
        EXPECT_NEAR(L.xx[0] + L.yy[0] + growth_of_turn(dt, L, 0), 0.0, 1e-12 / dt); // det(I + dt L) = 1
        take_gradients_of_the_middle(dt, particles);
        EXPECT_NEAR(L.xx[0], 0.0, 1e-13 / dt);
        EXPECT_NEAR(L.yy[0], 0.0, 1e-13 / dt);
        EXPECT_NEAR(L.xy[0] + L.yx[0], 0.0, 1e-13 / dt);
        // the stress turns by twice atan(dt (L_yx - L_xy)/4)
        EXPECT_NEAR(2.0 * std::atan(0.25 * dt * (L.yx[0] - L.xy[0])), angle, 1e-13);
    }
}

// Of a stretch by 1 + e they have the strain e/(1 + e/2): ln(1 + e) to the third order.
TEST(GradientsOfTheMiddle, HaveTheLogarithmicStrainOfAStretch)
{
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.velocity_gradient_solid = {{0.2}, {0.0}, {0.0}, {-0.1}};
    take_gradients_of_the_middle(1.0, particles);
    EXPECT_NEAR(particles.velocity_gradient_solid.xx[0], 0.2 / 1.1, 1e-15);
    EXPECT_NEAR(particles.velocity_gradient_solid.yy[0], -0.1 / 0.95, 1e-15);
}

} // namespace
} // namespace quicksand
