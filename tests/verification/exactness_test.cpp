// Motions the step must reproduce to rounding: free fall, rigid rotation, momentum of a free body.
#include "solver/measure/balances.hpp"
#include "solver/motion/particle_motion.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

/// A free block in the middle of a grid of 12 x 12 cells of 0.1 m.
Problem free_block(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.1, 12, 12};
    problem.materials = {stiff_sand()};
    if (saturated) problem.water = water_to(10.0);
    problem.gravity = 0.0;
    return problem;
}

bool in_block(const Vector2& x)
{
    return x.x() > 0.4 && x.x() < 0.8 && x.y() > 0.4 && x.y() < 0.8;
}

TEST(FreeFall, DryBlockFallsAsAPointAndStaysFreeOfStress)
{
    Problem problem = free_block(false);
    problem.gravity = 9.81;
    State state = fill(problem, 3, in_block);
    SinglePhaseWorkspace work = make_single_phase_workspace(problem);
    const Vector2 start = state.particles.position[0];
    const int steps = 400;
    const double dt = 1e-4;
    for (int k = 0; k < steps; ++k) advance_single_phase_step(problem, dt, 0.0, state, work);

    const double t = steps * dt;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        // velocities stand in the middle of the last step
        EXPECT_NEAR(state.particles.velocity_solid.y[p], -9.81 * (t - 0.5 * dt), 1e-12);
        EXPECT_NEAR(state.particles.velocity_solid.x[p], 0.0, 1e-12);
        EXPECT_NEAR(state.particles.stress.yy[p], 0.0, 1e-3); // of a modulus of 1e8
    }
    EXPECT_NEAR(state.particles.position.y[0] - start.y(), -0.5 * 9.81 * t * t, 1e-12);
}

/// Set a body in motion so that it turns by an angle in a step: v = (R - I) x / dt over the positions at its
/// start, with velocities of the middle of the step.
void turn_in_step(double angle, double dt, bool saturated, Particles& particles)
{
    Eigen::Matrix2d L;
    L << (std::cos(angle) - 1.0) / dt, -std::sin(angle) / dt, std::sin(angle) / dt,
        (std::cos(angle) - 1.0) / dt;
    const auto set = [&](Vectors& velocity, Gradients& affine) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            velocity.set(p, L * (particles.position[p] - Vector2(0.6, 0.6)));
            affine.xx[p] = L(0, 0), affine.xy[p] = L(0, 1);
            affine.yx[p] = L(1, 0), affine.yy[p] = L(1, 1);
        }
    };
    set(particles.velocity_solid, particles.affine_velocity_solid);
    if (saturated) set(particles.velocity_fluid, particles.affine_velocity_fluid);
}

TEST(RigidRotation, OneStepGivesNoStressWhateverItsAngle)
{
    for (const double angle : {3e-5, 0.01, 0.3}) {
        for (const bool saturated : {false, true}) {
            const Problem problem = free_block(saturated);
            State state = fill(problem, 3, in_block);
            Particles& particles = state.particles;
            const Scalars volume = particles.volume;
            turn_in_step(angle, 1e-5, saturated, particles);
            if (saturated) {
                TwoPhaseWorkspace work = make_two_phase_workspace(problem);
                advance_two_phase_step(problem, 1e-5, state, work);
                for (const double pressure : particles.pore_pressure)
                    EXPECT_NEAR(pressure, 0.0, 1e-4) << angle; // of 2.2e9 Pa
            } else {
                SinglePhaseWorkspace work = make_single_phase_workspace(problem);
                advance_single_phase_step(problem, 1e-5, 0.0, state, work);
            }
            for (std::size_t p = 0; p < particles.size(); ++p) {
                EXPECT_NEAR(particles.stress.xx[p], 0.0, 1e-5) << angle;
                EXPECT_NEAR(particles.stress.yy[p], 0.0, 1e-5) << angle;
                EXPECT_NEAR(particles.stress.xy[p], 0.0, 1e-5) << angle;
                EXPECT_NEAR(particles.volume[p] / volume[p], 1.0, 1e-13) << angle;
            }
        }
    }
}

/// A body with the spin of 3 rad/s, half a turn later.
State half_a_turn(const Problem& problem)
{
    State state = fill(problem, 3, in_block);
    Particles& particles = state.particles;
    const double omega = 3.0;
    turn_in_step(1e-9 * omega, 1e-9, water_flow(problem) == WaterFlow::coupled, particles);
    open_balances(problem, state);
    run(problem, std::numbers::pi / omega, {}, state);
    return state;
}

// With the divergence at the start of the step alone it lost dt w^2 of the water's volume in a unit of time,
// and pressed itself apart by K_w times that.
TEST(RigidRotation, ABodyKeepsItsVolumeAndItsWater)
{
    Problem problem = free_block(true);
    problem.water->bulk_modulus = 2e7; // steps of 1e-4 s
    problem.materials[0].law = LinearElastic{1e6, 0.3};
    for (const WaterFlow flow : {WaterFlow::undrained, WaterFlow::coupled}) {
        for (const TimeScheme scheme : {TimeScheme::explicit_steps, TimeScheme::semi_implicit}) {
            problem.water->flow = flow;
            problem.scheme = scheme;
            const State state = half_a_turn(problem);
            double volume = 0.0, most = 0.0;
            for (std::size_t p = 0; p < state.particles.size(); ++p) {
                volume += state.particles.volume[p];
                most = std::max(most, std::abs(state.particles.pore_pressure[p]));
            }
            EXPECT_NEAR(volume / 0.16, 1.0, 5e-4);
            EXPECT_LT(most, 2.0 * 2000.0 * 9.0 * 0.08); // rho w^2 R^2: the stress of the turn is half of it
            EXPECT_LT(std::abs(balance(problem, state).water_error), 1e-5);
        }
    }
}

TEST(RigidRotation, StressTurnsWithTheBody)
{
    const Problem problem = free_block(false);
    State state = fill(problem, 1, in_block);
    Particles& particles = state.particles;
    particles.stress.xx[0] = -3e5;
    particles.stress.yy[0] = -1e5;
    particles.stress.xy[0] = 4e4;
    const int steps = 1000;
    const double omega = 0.5 * std::numbers::pi / steps; // a quarter turn in all, dt = 1
    particles.velocity_gradient_solid.xy[0] = -omega;
    particles.velocity_gradient_solid.yx[0] = omega;
    for (int k = 0; k < steps; ++k) update_effective_stress(problem, 1.0, particles);

    // R sigma R^T of a quarter turn exchanges the axes; the half-angle tangent errs by w^3/12 per step
    EXPECT_NEAR(particles.stress.xx[0], -1e5, 0.2);
    EXPECT_NEAR(particles.stress.yy[0], -3e5, 0.2);
    EXPECT_NEAR(particles.stress.xy[0], -4e4, 0.2);
    const double radius =
        std::hypot(0.5 * (particles.stress.xx[0] - particles.stress.yy[0]), particles.stress.xy[0]);
    EXPECT_NEAR(radius, std::hypot(1e5, 4e4), 1e-7);
}

/// Momentum of both phases; the masses of water are given by lasting particle number [N s/m].
Vector2 momentum(const Particles& particles, const Scalars& mass_fluid)
{
    Vector2 sum = Vector2::Zero();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        sum += particles.mass_solid[p] * particles.velocity_solid[p];
        sum += mass_fluid[static_cast<std::size_t>(particles.identifier[p])] * particles.velocity_fluid[p];
    }
    return sum;
}

TEST(Momentum, OfAFreeSaturatedBodyIsConservedToRoundingInEveryStep)
{
    const Problem problem = free_block(true);
    State state = fill(problem, 3, in_block);
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        // some irregular motion of both phases and irregular stresses and pressures
        const double s = std::sin(12.9898 * static_cast<double>(p + 1)),
                     c = std::cos(78.233 * static_cast<double>(p + 1));
        particles.velocity_solid.set(p, {0.02 * s + 0.01, 0.03 * c});
        particles.velocity_fluid.set(p, {0.02 * c, 0.02 * s - 0.01});
        particles.stress.xx[p] = 1e3 * s;
        particles.stress.xy[p] = 1e3 * c;
        particles.pore_pressure[p] = 2e3 * s * c;
    }
    TwoPhaseWorkspace work = make_two_phase_workspace(problem);
    const double dt = stable_time_step(problem, particles).dt;
    Scalars mass_fluid(particles.size());
    for (int k = 0; k < 200; ++k) {
        // the water that follows a particle's pores changes after the momentum has been exchanged
        double scale = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            mass_fluid[static_cast<std::size_t>(particles.identifier[p])] =
                problem.water->density * particles.porosity[p] * particles.volume[p];
            scale += particles.mass_solid[p] * particles.velocity_solid[p].norm();
        }
        const Vector2 before = momentum(particles, mass_fluid);
        advance_two_phase_step(problem, dt, state, work);
        EXPECT_LT((momentum(particles, mass_fluid) - before).norm(), 1e-13 * scale);
    }
}

} // namespace
} // namespace quicksand
