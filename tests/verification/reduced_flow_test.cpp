// Undrained and drained soil: the forms of the equations with one velocity.
#include "solver/motion/particle_order.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace quicksand {
namespace {

using namespace fixtures;

/// A layer between two fixed walls, one cell wide, half a wave long, without gravity.
Problem layer(WaterFlow flow, int cells)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0 / cells, 1, cells};
    problem.materials = {stiff_sand()};
    problem.water = water_to(1.0);
    problem.water->flow = flow;
    problem.gravity = 0.0;
    problem.boundaries =
        rectangle(0.0, 0.0, problem.grid.cell_size, 1.0, FixedWall{}, RollerWall{}, FixedWall{});
    return problem;
}

State waving(const Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double phase = std::numbers::pi * particles.position.y[p];
        particles.velocity_solid.y[p] = 1e-3 * std::sin(phase);
        particles.affine_velocity_solid.yy[p] = 1e-3 * std::numbers::pi * std::cos(phase);
    }
    if (problem.water->flow == WaterFlow::coupled) {
        particles.velocity_fluid = particles.velocity_solid;
        particles.affine_velocity_fluid = particles.affine_velocity_solid;
    }
    return state;
}

/// Amplitude of sin(pi y) in the velocity [m/s].
double amplitude(const Particles& particles)
{
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        sum += particles.velocity_solid.y[p] * std::sin(std::numbers::pi * particles.reference_position.y[p]);
    }
    return 2.0 * sum / static_cast<double>(particles.size());
}

/// Speed of the standing wave from the time of three half periods [m/s].
double measured_speed(const Problem& problem, State state)
{
    SinglePhaseWorkspace work = make_single_phase_workspace(problem);
    const double dt = stable_time_step(problem, state.particles).dt;
    double before = amplitude(state.particles), first = 0.0, last = 0.0;
    for (int crossings = 0; crossings < 4;) {
        advance_single_phase_step(problem, dt, 0.0, state, work);
        const double now = amplitude(state.particles);
        if (now * before < 0.0) {
            last = state.time - dt * now / (now - before);
            if (crossings++ == 0) first = last;
        }
        before = now;
    }
    const double period = 2.0 * (last - first) / 3.0;
    return 2.0 / period; // the wave is 2 m long
}

TEST(UndrainedFlow, LongitudinalWaveTravelsAtTheUndrainedSpeed)
{
    const Problem problem = layer(WaterFlow::undrained, 10); // 20 cells per wavelength
    const double expected = wave_speeds(problem.materials[0], problem.water, stiff_sand().porosity).undrained;
    EXPECT_NEAR(measured_speed(problem, waving(problem)), expected, 0.005 * expected);
}

TEST(DrainedFlow, LongitudinalWaveTravelsAtTheSpeedOfTheSkeletonThatCarriesTheWater)
{
    const Problem problem = layer(WaterFlow::drained, 10);
    const double expected = wave_speeds(problem.materials[0], problem.water, stiff_sand().porosity).skeleton;
    EXPECT_NEAR(measured_speed(problem, waving(problem)), expected, 0.005 * expected);
}

TEST(UndrainedFlow, IsTheLimitOfCoupledFlowWithoutConductivity)
{
    Problem tight = layer(WaterFlow::coupled, 10);
    tight.materials[0].hydraulic_conductivity = 1e-14;
    const Problem undrained = layer(WaterFlow::undrained, 10);
    State two = waving(tight), one = waving(undrained);
    TwoPhaseWorkspace work_of_two = make_two_phase_workspace(tight);
    SinglePhaseWorkspace work_of_one = make_single_phase_workspace(undrained);
    work_of_one.null_space_time = work_of_two.null_space_time; // their fastest waves differ
    const double dt = stable_time_step(tight, two.particles).dt;
    EXPECT_LT(dt, stable_time_step(undrained, one.particles).dt);
    double largest = 0.0;
    for (int step = 0; step < 400; ++step) {
        advance_two_phase_step(tight, dt, two, work_of_two);
        advance_single_phase_step(undrained, dt, 0.0, one, work_of_one);
        for (std::size_t p = 0; p < one.particles.size(); ++p) {
            ASSERT_NEAR(one.particles.velocity_solid.y[p], two.particles.velocity_solid.y[p], 1e-8);
            ASSERT_NEAR(one.particles.pore_pressure[p], two.particles.pore_pressure[p], 1e-2);
            largest = std::max(largest, one.particles.pore_pressure[p]);
        }
    }
    EXPECT_GT(largest, 2e3) << "of which the differences are less than a hundred-thousandth";
}

TEST(UndrainedFlow, FreeBlockKeepsItsMomentum)
{
    Problem problem = layer(WaterFlow::undrained, 8);
    problem.grid = {{0.0, 0.0}, 0.1, 12, 12};
    problem.boundaries = {};
    State state = fill(problem, 3, [](const Vector2& x) {
        return x.x() > 0.4 && x.x() < 0.8 && x.y() > 0.4 && x.y() < 0.8;
    });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 x = particles.position[p];
        particles.velocity_solid.set(p, {1.0 + std::sin(9.0 * x.y()), -0.5 + std::cos(7.0 * x.x())});
        particles.pore_pressure[p] = 1e5 * std::sin(11.0 * x.x() + 5.0 * x.y());
    }
    SinglePhaseWorkspace work = make_single_phase_workspace(problem);
    const auto momentum = [&] {
        compute_carried_masses(problem, state, work.masses);
        Vector2 sum = Vector2::Zero();
        for (std::size_t p = 0; p < particles.size(); ++p)
            sum += work.masses.inertia[p] * particles.velocity_solid[p];
        return sum;
    };
    const Vector2 before = momentum();
    for (int step = 0; step < 300; ++step)
        advance_single_phase_step(problem, stable_time_step(problem, particles).dt, 0.0, state, work);
    EXPECT_LT((momentum() - before).norm(), 1e-12 * before.norm());
}

TEST(UndrainedFlow, LevelColumnStaysAtRest)
{
    Problem problem = centrifuge_column();
    problem.water->flow = WaterFlow::undrained;
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    set_level_ground_stress(problem, 0.3175, 0.5, state);
    run(problem, 500.0 * stable_time_step(problem, state.particles).dt, {}, state);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        EXPECT_LT(state.particles.velocity_solid[p].norm(), 1e-6 * std::sqrt(problem.gravity * 0.3175));
        EXPECT_LT(std::abs(state.particles.pore_pressure[p]), 400.0); // of a static pressure of 370 kPa
    }
}

TEST(DrainedFlow, SwingsAboutTheSettlementOfTheBuoyantSkeleton)
{
    Problem problem = layer(WaterFlow::drained, 20);
    problem.boundaries =
        rectangle(0.0, 0.0, problem.grid.cell_size, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
    problem.strain = StrainForm::small;
    problem.gravity = standard_gravity; // put on at once: every mode swings about the settled shape
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    EXPECT_TRUE(state.particles.pore_pressure.empty());

    const Material& sand = problem.materials[0];
    const double M = std::visit([](const auto& law) { return constrained_modulus(law); }, sand.law);
    const double unit_weight = (1.0 - sand.porosity) * (sand.grain_density - 1000.0) * problem.gravity;
    const double period = 4.0 / wave_speeds(sand, problem.water, sand.porosity).skeleton;
    SinglePhaseWorkspace work = make_single_phase_workspace(problem);
    const int steps = 2 * static_cast<int>(period / stable_time_step(problem, state.particles).dt);
    double mean = 0.0, most = 0.0;
    for (int step = 0; step < steps; ++step) {
        advance_single_phase_step(problem, period / steps, 0.0, state, work);
        const auto top = std::max_element(state.particles.reference_position.y.begin(),
                                          state.particles.reference_position.y.end());
        const auto p = static_cast<std::size_t>(top - state.particles.reference_position.y.begin());
        const double settlement = *top - state.particles.position.y[p];
        mean += settlement / steps;
        most = std::max(most, settlement);
    }
    const double Y = *std::max_element(state.particles.reference_position.y.begin(),
                                       state.particles.reference_position.y.end());
    const double expected = unit_weight * (Y - 0.5 * Y * Y) / M;
    EXPECT_NEAR(mean, expected, 0.002 * expected);
    EXPECT_NEAR(most, 2.0 * expected, 0.02 * expected);
}

TEST(ReducedFlow, CarriesNoArraysThatItDoesNotUse)
{
    const auto bytes_per_particle = [](std::optional<WaterFlow> flow) {
        Particles particles;
        resize(particles, 1000, flow);
        EXPECT_EQ(carried_flow(particles), flow);
        return static_cast<double>(memory_bytes(particles)) / 1000.0;
    };
    const double dry = bytes_per_particle(std::nullopt);
    EXPECT_EQ(bytes_per_particle(WaterFlow::drained), dry + 8.0);    // porosity
    EXPECT_EQ(bytes_per_particle(WaterFlow::undrained), dry + 24.0); // and pressure, water
    EXPECT_EQ(bytes_per_particle(WaterFlow::coupled), dry + 64.0);   // velocity and its gradient, no water
}

} // namespace
} // namespace quicksand
