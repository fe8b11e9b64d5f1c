// Balances of energy, momentum and water.
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

/// A free block of 8 x 8 cells in a larger grid, no gravity; its own motion is set by the test.
Problem free_block(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.125, 16, 16};
    problem.materials = {stiff_sand()};
    if (saturated) problem.water = water_to(2.0);
    problem.gravity = 0.0;
    return problem;
}

State block_at_centre(const Problem& problem)
{
    return fill(problem, 3,
                [](const Vector2& x) { return (x - Vector2(1.0, 1.0)).cwiseAbs().maxCoeff() < 0.5; });
}

/// v = amplitude sin(pi (x - 1)) along x in the block of 1 m, and a drift; both phases alike.
void set_vibrating(double amplitude, const Vector2& drift, Particles& particles)
{
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles.position.x[p] - 1.0;
        const Vector2 velocity = drift + Vector2(amplitude * std::sin(std::numbers::pi * x), 0.0);
        particles.velocity_solid.set(p, velocity);
        particles.affine_velocity_solid.xx[p] = amplitude * std::numbers::pi * std::cos(std::numbers::pi * x);
        if (!particles.has_fluid()) continue;
        particles.velocity_fluid.set(p, velocity);
        particles.affine_velocity_fluid.xx[p] = particles.affine_velocity_solid.xx[p];
    }
}

/// sum V (sigma' : C^-1 : sigma') / 2 of a linear elastic body [J/m].
double strain_energy(const Problem& problem, const Particles& particles)
{
    const auto& law = std::get<LinearElastic>(problem.materials[0].law);
    const double G = law.shear_modulus, nu = law.poisson_ratio;
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double xx = particles.stress.xx[p], yy = particles.stress.yy[p], zz = particles.stress.zz[p],
                     xy = particles.stress.xy[p];
        const double trace = xx + yy + zz;
        sum += particles.volume[p] *
               (xx * xx + yy * yy + zz * zz + 2.0 * xy * xy - nu / (1.0 + nu) * trace * trace);
    }
    return sum / (4.0 * G);
}

/// A run in `steps` equal steps.
void run_steps(const Problem& problem, double end_time, int steps, State& state)
{
    const double dt = end_time / steps;
    if (problem.water) {
        TwoPhaseWorkspace work = make_two_phase_workspace(problem);
        for (int k = 0; k < steps; ++k) advance_two_phase_step(problem, dt, state, work);
    } else {
        SinglePhaseWorkspace work = make_single_phase_workspace(problem);
        for (int k = 0; k < steps; ++k) advance_single_phase_step(problem, dt, 0.0, state, work);
    }
}

/// Greatest of |stress work - strain energy| at six times of two periods, relative to the opening kinetic
/// energy.
double work_misfit(int steps_per_part)
{
    const Problem problem = free_block(false);
    State state = block_at_centre(problem);
    set_vibrating(0.01, Vector2::Zero(), state.particles);
    open_balances(problem, state);
    const double part = 10.0 * stable_time_step(problem, state.particles).dt;
    double misfit = 0.0;
    for (int k = 0; k < 6; ++k) {
        run_steps(problem, part, steps_per_part, state);
        const double misfit_now =
            state.balance_terms->skeleton_work - strain_energy(problem, state.particles);
        misfit = std::max(misfit, std::abs(misfit_now) / state.balance_terms->opening_kinetic_energy);
        EXPECT_LT(std::abs(balance(problem, state).energy_error), 1e-14);
    }
    return misfit;
}

TEST(BalanceTerms, StressWorkOfAVibratingBlockIsItsStrainEnergyToFirstOrderInTheTimeStep)
{
    const double stable = work_misfit(10), half = work_misfit(20), quarter = work_misfit(40);
    EXPECT_LT(stable, 0.08); // 0.076, at 0.65 of the Courant limit and eight cells of half a wave
    EXPECT_NEAR(stable / half, 2.0, 0.25);
    EXPECT_NEAR(half / quarter, 2.0, 0.25);
}

TEST(BalanceTerms, NumericalLossOfAVibratingBlockIsSmall)
{
    const Problem problem = free_block(false);
    State state = block_at_centre(problem);
    set_vibrating(0.01, Vector2::Zero(), state.particles);
    open_balances(problem, state);
    run_steps(problem, 60.0 * stable_time_step(problem, state.particles).dt, 60, state);
    EXPECT_LT(std::abs(balance(problem, state).numerical_loss),
              0.0025 * state.balance_terms->opening_kinetic_energy);
}

TEST(BalanceTerms, MomentumOfAFreeBlockOfTwoPhasesIsConservedToRounding)
{
    const Problem problem = free_block(true);
    State state = block_at_centre(problem);
    set_vibrating(0.01, {0.3, -0.2}, state.particles);
    open_balances(problem, state);
    const double momentum = state.balance_terms->opening_momentum_x;
    run_steps(problem, 60.0 * stable_time_step(problem, state.particles).dt, 60, state);
    const BalanceErrors balances = balance(problem, state);
    EXPECT_LT(std::abs(balances.momentum_error_x), 1e-13 * momentum);
    EXPECT_LT(std::abs(balances.momentum_error_y), 1e-13 * momentum);
    EXPECT_EQ(state.balance_terms->impulse_x, 0.0);
    // the pores breathe with the vibration, and their water comes with its velocity
    EXPECT_LT(std::abs(state.balance_terms->exchange_x), 1e-5 * momentum);
}

TEST(BalanceTerms, EnergyOfASaturatedVibratingBlockIsAccountedFor)
{
    const Problem problem = free_block(true);
    double errors[2];
    for (const int steps : {60, 120}) {
        State state = block_at_centre(problem);
        set_vibrating(0.01, Vector2::Zero(), state.particles);
        open_balances(problem, state);
        run_steps(problem, 60.0 * stable_time_step(problem, state.particles).dt, steps, state);
        errors[steps / 120] = std::abs(balance(problem, state).energy_error);
        EXPECT_GT(state.balance_terms->drag_dissipation, 0.0);
    }
    EXPECT_LT(errors[0], 0.018);
    EXPECT_LT(errors[1], 0.6 * errors[0]);
}

TEST(BalanceTerms, WorkAndImpulseOfTheWeightAndTheBaseAreTheKineticEnergyAndMomentumOfAFallingBlock)
{
    Problem problem = free_block(true);
    problem.gravity = standard_gravity;
    problem.base_motion = SineMotion{2.0, 10.0, 1e9, 0.0};
    problem.water.reset();
    State state = block_at_centre(problem);
    open_balances(problem, state);
    run_steps(problem, 0.01, 100, state);
    const Monitors sums = monitor(problem, state, {});
    const double mass = sums.mass_solid;
    const double speed = standard_gravity * (0.01 - 0.5 * state.last_step); // in the middle of the last step
    EXPECT_NEAR(state.balance_terms->impulse_y, -mass * speed, 1e-12 * mass);
    EXPECT_NEAR(state.balance_terms->impulse_x, sums.momentum_x, 1e-12 * mass);
    EXPECT_LT(sums.momentum_x, 0.0);
    EXPECT_NEAR(state.balance_terms->gravity_work, 0.5 * mass * speed * speed, 1e-12 * mass);
    EXPECT_NEAR(state.balance_terms->gravity_work + state.balance_terms->base_work, sums.kinetic_energy,
                1e-12 * mass);
    EXPECT_EQ(state.balance_terms->boundary_work, 0.0);
}

TEST(BalanceTerms, ReactionsCarryTheWeightOfAColumnAtRest)
{
    const Problem problem = centrifuge_column();
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    set_level_ground_stress(problem, 0.3175, 0.5, state);
    open_balances(problem, state);
    run_steps(problem, 200.0 * stable_time_step(problem, state.particles).dt, 200, state);
    const Monitors sums = monitor(problem, state, {});
    const double weight_impulse = sums.mass_solid * problem.gravity * state.time;
    EXPECT_LT(std::abs(state.balance_terms->impulse_y), 1e-9 * weight_impulse);
    EXPECT_LT(std::abs(balance(problem, state).momentum_error_y), 1e-13 * weight_impulse);
    EXPECT_LT(std::abs(state.balance_terms->boundary_work), 1e-20);
}

TEST(BalanceTerms, WaterThatLeavesAConsolidatingLayerIsTheChangeOfItsWater)
{
    Problem problem;
    const int cells = 10;
    problem.grid = {{0.0, 0.0}, 1.0 / cells, 1, cells + 1};
    Material sand = stiff_sand();
    sand.law = LinearElastic{5e6, 0.0};
    sand.hydraulic_conductivity = 1e-2;
    problem.materials = {sand};
    problem.water = water_to(1.0);
    problem.gravity = 0.0;
    problem.boundaries =
        rectangle(0.0, 0.0, problem.grid.cell_size, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    const double p0 = 10e3;
    std::fill(state.particles.pore_pressure.begin(), state.particles.pore_pressure.end(), p0);
    std::fill(state.particles.stress.yy.begin(), state.particles.stress.yy.end(), p0);
    open_balances(problem, state);
    const double mass = monitor(problem, state, {}).mass_solid;
    run(problem, 0.2, {}, state); // T = 2: less than a per cent is left
    // settlement p0 H / M = 1 mm, and the water's own expansion
    EXPECT_NEAR(state.balance_terms->outflow,
                problem.grid.cell_size * (p0 / 10e6 + sand.porosity * p0 / 2.2e9),
                0.01 * problem.grid.cell_size * p0 / 10e6);
    // the step leaves the water's density out of its flux: p0 / K_w = 5e-6 of the outflow
    EXPECT_LT(std::abs(balance(problem, state).water_error), 1e-8);
    EXPECT_EQ(monitor(problem, state, {}).mass_solid, mass);
}

TEST(BalanceTerms, LoadsWorkAtTheBoundaryAndNotInTheSkeleton)
{
    for (const bool saturated : {false, true}) {
        Problem problem = free_block(saturated);
        problem.boundaries = rectangle(0.5, 0.5, 1.5, 1.5, FreeFace{}, FreeFace{}, FreeFace{});
        problem.boundaries[1].soil = FreeFace{SurfaceLoad{{3e4, -1e4}, 0.0, {}}};
        State state = block_at_centre(problem);
        ASSERT_TRUE(attach_boundaries(problem, state.particles).empty());
        open_balances(problem, state);
        run_steps(problem, 60.0 * stable_time_step(problem, state.particles).dt, 60, state);
        const BalanceTerms& terms = *state.balance_terms;
        const BalanceErrors balances = balance(problem, state);
        const double middle_of_last_step = state.time - 0.5 * state.last_step;
        EXPECT_NEAR(terms.impulse_x, 3e4 * middle_of_last_step, 1e-10);
        EXPECT_NEAR(terms.impulse_y, -1e4 * middle_of_last_step, 1e-10);
        EXPECT_LT(std::hypot(balances.momentum_error_x, balances.momentum_error_y), 1e-13 * terms.impulse_x);
        EXPECT_GT(terms.boundary_work, 0.0);
        EXPECT_GT(terms.skeleton_work, 0.0);
        EXPECT_LT(std::abs(balances.energy_error), saturated ? 0.02 : 1e-14);
    }
}

TEST(BalanceTerms, CountsDashpotsWhereTheSoilHasTakenThem)
{
    Problem problem = free_block(true);
    problem.boundaries = rectangle(0.5, 0.5, 1.5, 1.5, ViscousFace{}, FreeFace{}, FreeFace{});
    State state = block_at_centre(problem);
    ASSERT_TRUE(attach_boundaries(problem, state.particles).empty());
    set_vibrating(0.0, {0.3, -2.0}, state.particles);
    open_balances(problem, state);
    const double momentum = std::abs(state.balance_terms->opening_momentum_y);
    run_steps(problem, 200.0 * stable_time_step(problem, state.particles).dt, 200, state);
    const BalanceErrors balances = balance(problem, state);
    EXPECT_GT(state.balance_terms->impulse_y, 0.1 * momentum);
    EXPECT_LT(std::abs(balances.momentum_error_x), 1e-12 * momentum);
    EXPECT_LT(std::abs(balances.momentum_error_y), 1e-12 * momentum);
}

TEST(BalanceTerms, HasTheSameBitsForAnyNumberOfThreads)
{
    const int threads = thread_count();
    std::vector<double> numbers[2];
    for (const int count : {1, 2}) {
        set_thread_count(count);
        const Problem problem = centrifuge_column();
        State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3; });
        open_balances(problem, state);
        run_steps(problem, 20.0 * stable_time_step(problem, state.particles).dt, 20, state);
        for_each_number(*state.balance_terms,
                        [&](const char*, double value) { numbers[count - 1].push_back(value); });
    }
    set_thread_count(threads);
    EXPECT_EQ(numbers[0], numbers[1]);
    EXPECT_GT(numbers[0].size(), 10u);
}

} // namespace
} // namespace quicksand
