// The semi-implicit step: the same equations as the explicit step, at a larger step.
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/restless_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double patch_cell = 0.0075; // cell size of the patches [m]

Problem semi_implicit_patch(double conductivity)
{
    Problem problem = patch(conductivity, true);
    problem.scheme = TimeScheme::semi_implicit;
    return problem;
}

/// Of the kinetic energy over 1500 steps, which are these fractions of the stable one by turns.
double semi_implicit_growth(const Problem& problem, const std::vector<double>& fractions)
{
    State state = restless(problem);
    const double stable = stable_time_step(problem, state.particles).dt;
    const double before = monitor(problem, state, {}).kinetic_energy;
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    try {
        for (std::size_t k = 0; k < 1500; ++k) {
            const double fraction = fractions[k % fractions.size()];
            advance_semi_implicit_step(problem, fraction * stable, state, work);
        }
    } catch (const NumericalError&) {
        return std::numeric_limits<double>::infinity(); // blown off the grid
    }
    return monitor(problem, state, {}).kinetic_energy / before;
}

TEST(SemiImplicitStep, RandomMotionDecaysForEveryPermeability)
{
    for (const double conductivity : {1e-2, 1e-3, 1e-4, 1e-5, 1e-7})
        EXPECT_LT(semi_implicit_growth(semi_implicit_patch(conductivity), {1.0}), 1e-2) << conductivity;
}

/// As where histories and probes are written in intervals that do not suit each other.
TEST(SemiImplicitStep, RandomMotionDecaysInStepsThatAreLongAndShortByTurns)
{
    for (const std::vector<double>& fractions : {std::vector{1.0, 0.1},
                                                 {1.0, 1.0, 0.1},
                                                 {1.0, 1.0, 1.0, 1.0, 0.02},
                                                 {1.0, 0.1, 0.9, 0.2, 0.8, 0.3, 0.7, 0.4, 0.6, 0.5}})
        for (const double conductivity : {1e-3, 1e-5})
            EXPECT_LT(semi_implicit_growth(semi_implicit_patch(conductivity), fractions), 1e-2)
                << fractions.size() << " steps, the second of " << fractions[1] << ", k " << conductivity;
}

TEST(SemiImplicitStep, AnUnsolvedPressureIsANumericalFailure)
{
    const Problem problem = semi_implicit_patch(1e-4);
    State state = restless(problem);
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    work.controls.tolerance = 0.0;
    work.controls.max_iterations = 1;
    try {
        advance_semi_implicit_step(problem, stable_time_step(problem, state.particles).dt, state, work);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        EXPECT_EQ(error.record.what, "the pressure of the cells is not found within 1 iterations; the "
                                     "particle below is the fastest");
        EXPECT_EQ(std::string(error.record.causes).find("the time step is too long"), 0U);
    }
}

TEST(SemiImplicitStep, APressureOfNoNumberIsToldAsSuch)
{
    const Problem problem = semi_implicit_patch(1e-4);
    State state = restless(problem);
    const double dt = stable_time_step(problem, state.particles).dt;
    const std::int64_t spoiled = state.particles.identifier[7];
    state.particles.velocity_solid.x[7] = std::numeric_limits<double>::quiet_NaN();
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    try {
        advance_semi_implicit_step(problem, dt, state, work);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("the pressure of the cells is not a number"), std::string::npos) << text;
        EXPECT_EQ(error.record.identifier, spoiled);
    }
}

TEST(SemiImplicitStep, AStiffParticleCountsByItsPartOfTheCell)
{
    for (const double ratio : {9.0, 36.0}) {
        auto [problem, state, dt] = with_stiff_points(ratio, semi_implicit_patch(1e-4));
        EXPECT_GT(dt, 1.1 * stable_time_step(problem, state.particles).dt) << "two materials do not mix";
        const double before = monitor(problem, state, {}).kinetic_energy;
        SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
        for (int k = 0; k < 1500; ++k) advance_semi_implicit_step(problem, dt, state, work);
        EXPECT_LT(monitor(problem, state, {}).kinetic_energy, 0.01 * before) << ratio;
    }
}

TEST(SemiImplicitStep, RandomMotionGrowsFarBeyondTheStep)
{
    EXPECT_GT(semi_implicit_growth(semi_implicit_patch(1e-4), {1.6}), 1.0);
}

TEST(SemiImplicitStep, IsSeveralTimesTheExplicitStep)
{
    Problem problem = semi_implicit_patch(1e-4);
    const State state = restless(problem);
    const double semi_implicit = stable_time_step(problem, state.particles).dt;
    problem.scheme = TimeScheme::explicit_steps;
    EXPECT_GT(semi_implicit / stable_time_step(problem, state.particles).dt, 4.0);
}

/// A saturated block on a base shaken at 180 Hz, its sides free: pressures, drag and slopes all at work.
Problem shaken_patch_block()
{
    Problem problem = semi_implicit_patch(1e-4);
    problem.gravity = 1000.0;
    problem.base_motion = SineMotion{200.0, 180.0, 1e9, 2.0};
    problem.boundaries =
        rectangle(patch_cell, 0.0, 8 * patch_cell, 0.0625, FixedWall{}, FreeFace{}, FreeFace{});
    return problem;
}

/// State after `steps` steps of dt, at rest under no stress at first.
State after(const Problem& problem, double dt, int steps)
{
    State state = fill(problem, 3, [](const Vector2& x) {
        return x.x() > patch_cell && x.x() < 8 * patch_cell && x.y() < 0.0625;
    });
    if (problem.scheme == TimeScheme::semi_implicit) {
        SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
        work.controls.tolerance = 1e-9;
        for (int k = 0; k < steps; ++k) advance_semi_implicit_step(problem, dt, state, work);
    } else {
        TwoPhaseWorkspace work = make_two_phase_workspace(problem);
        for (int k = 0; k < steps; ++k) advance_two_phase_step(problem, dt, state, work);
    }
    return state;
}

/// Root of the mean square difference of the pressures over that of the reference [-].
double pressure_difference(const Particles& a, const Particles& reference)
{
    double difference = 0.0, scale = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        difference += std::pow(a.pore_pressure[p] - reference.pore_pressure[p], 2);
        scale += std::pow(reference.pore_pressure[p], 2);
    }
    return std::sqrt(difference / scale);
}

TEST(SemiImplicitStep, ConvergesToTheExplicitAnswerWithTheStep)
{
    Problem problem = shaken_patch_block();
    const double end = 2e-4; // s: the water's sound crosses the block five times
    problem.scheme = TimeScheme::explicit_steps;
    const State reference = after(problem, end / 3200, 3200);
    problem.scheme = TimeScheme::semi_implicit;
    double errors[3];
    for (int k = 0; k < 3; ++k) {
        const int steps = 800 << k;
        errors[k] = pressure_difference(after(problem, end / steps, steps).particles, reference.particles);
    }
    EXPECT_LT(errors[2], 5e-4);            // measured 0.33, 0.13 and 0.029 %
    EXPECT_GT(errors[1] / errors[2], 4.0); // second order in time
}

TEST(SemiImplicitStep, ALevelColumnStaysAtRest)
{
    Problem problem = centrifuge_column();
    problem.scheme = TimeScheme::semi_implicit;
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    set_level_ground_stress(problem, 0.3175, 0.5, state);
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    const double dt = stable_time_step(problem, state.particles).dt;
    for (int k = 0; k < 200; ++k) advance_semi_implicit_step(problem, dt, state, work);
    EXPECT_LT(monitor(problem, state, {}).max_velocity, 1e-12 * std::sqrt(problem.gravity * 0.3175));
}

TEST(SemiImplicitStep, GivesTheSameBitsForAnyNumberOfThreads)
{
    const Problem problem = shaken_patch_block();
    const int threads_before = thread_count();
    const double dt = 1e-5;
    set_thread_count(1);
    const State one = after(problem, dt, 60);
    set_thread_count(3);
    const State three = after(problem, dt, 60);
    set_thread_count(threads_before);
    EXPECT_EQ(one.particles.pore_pressure, three.particles.pore_pressure);
    EXPECT_EQ(one.particles.velocity_fluid.y, three.particles.velocity_fluid.y);
}

TEST(SemiImplicitStep, GoesOnFromARestartPointWithTheSameBits)
{
    Problem problem = shaken_patch_block();
    problem.base_motion = SineMotion{200.0, 180.0, 1e9, 0.0};
    const double end = 2.4e-3;
    const State start = after(problem, 1e-5, 0);
    State through = start, stopped = start;
    run(problem, end, {}, through);
    ASSERT_GT(through.step, 64);
    run(problem, end, {}, stopped, [] { return true; });
    ASSERT_GT(stopped.step, 0);
    ASSERT_LT(stopped.time, end);
    run(problem, end, {}, stopped);
    EXPECT_EQ(through.step, stopped.step);
    EXPECT_EQ(through.particles.pore_pressure, stopped.particles.pore_pressure);
    EXPECT_EQ(through.particles.velocity_fluid.y, stopped.particles.velocity_fluid.y);
}

/// A closed column of 1 m and 20 cells, its grains and water tied together by drag, in its first mode of
/// compression: v = cos(pi (y - 1/2)).
State standing_wave(Problem& problem)
{
    problem.grid = {{0.0, 0.0}, 0.05, 1, 20};
    problem.materials = {stiff_sand()};
    problem.materials[0].hydraulic_conductivity = 1e-12;
    problem.water = water_to(1.0);
    problem.gravity = 0.0;
    problem.strain = StrainForm::small;
    problem.scheme = TimeScheme::semi_implicit;
    problem.boundaries = rectangle(0.0, 0.0, 0.05, 1.0, FixedWall{}, RollerWall{}, FixedWall{});
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.velocity_solid.y[p] = state.particles.velocity_fluid.y[p] =
            std::sin(std::numbers::pi * state.particles.position.y[p]);
    return state;
}

/// Displacement of the first mode [m].
double displacement_of_mode(const Particles& particles)
{
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.reference_position.y[p];
        sum += std::sin(std::numbers::pi * y) * (particles.position.y[p] - y);
    }
    return 2.0 * sum / static_cast<double>(particles.size());
}

TEST(SemiImplicitStep, LetsAWaveSwingAsTheEquationOfItsTimeStepSays)
{
    Problem problem;
    State state = standing_wave(problem);
    const Material& sand = problem.materials[0];
    const double n = sand.porosity, K = problem.water->bulk_modulus / n,
                 M = constrained_modulus(std::get<LinearElastic>(sand.law)),
                 density = (1.0 - n) * sand.grain_density + n * problem.water->density;
    // of linear elements with the masses at their nodes
    const double wave_number = 2.0 / 0.05 * std::sin(0.5 * std::numbers::pi * 0.05);
    const double water = K / density * wave_number * wave_number,
                 skeleton = M / density * wave_number * wave_number; // [1/s2]
    const double dt = 0.5 / std::sqrt(water + skeleton), b = acting_weight;
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    work.controls.tolerance = 1e-9;
    work.null_space_time = 1e9;
    double v = 1.0, u = 0.0, p = 0.0, r = 0.0, most = 0.0; // of the mode; p over its density and wave number
    for (int step = 0; step < 40; ++step) {                // three periods
        advance_semi_implicit_step(problem, dt, state, work);
        const double dt_v = step == 0 ? 0.5 * dt : dt;
        v = (v - dt_v * (skeleton * u + p - b * dt * r)) / (1.0 + b * dt * dt_v * water);
        r += b * (water * v - r);
        p += dt * water * v;
        u += dt * v;
        if (step >= 27) most = std::max(most, std::abs(u));
        EXPECT_NEAR(displacement_of_mode(state.particles), u, 5e-3 / std::sqrt(water + skeleton)) << step;
    }
    // backward Euler leaves 1 % after two periods
    EXPECT_GT(most * std::sqrt(water + skeleton), 0.6);
}

/// Displacement of the mode after 3.3 periods, with steps that follow its swing by 40 % about `mean` [m].
double displacement_with_uneven_steps(double mean, double conductivity)
{
    Problem problem;
    State state = standing_wave(problem);
    problem.materials[0].hydraulic_conductivity = conductivity;
    const double speed = wave_speeds(problem.materials[0], problem.water, 0.43).undrained;
    const double end = 3.3 * 2.0 / speed;
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    work.controls.tolerance = 1e-9;
    work.null_space_time = 1e9;
    while (state.time < end) {
        const double uneven = mean * (1.0 + 0.4 * std::sin(2.0 * std::numbers::pi * speed * state.time));
        advance_semi_implicit_step(problem, std::min(uneven, end - state.time), state, work);
    }
    return displacement_of_mode(state.particles);
}

TEST(SemiImplicitStep, IsOfSecondOrderInTimeWithStepsThatChangeTheirLength)
{
    for (const double conductivity : {1e-2, 1e-6}) { // of weak and of strong drag
        const double step = 1e-5, exact = displacement_with_uneven_steps(step / 32.0, conductivity);
        const double coarse = std::abs(displacement_with_uneven_steps(step, conductivity) - exact),
                     fine = std::abs(displacement_with_uneven_steps(step / 4.0, conductivity) - exact);
        EXPECT_GT(0.5 * std::log2(coarse / fine), 1.9) << conductivity;
    }
}

/// Iterations of the last of a few steps of a shaken layer, the blocks having been set up in the first.
int iterations(int cells_x, double tolerance, int steps)
{
    Problem problem = semi_implicit_patch(1e-5);
    problem.grid.cells_x = cells_x;
    problem.base_motion = SineMotion{200.0, 180.0, 1e9, 0.0};
    problem.boundaries =
        rectangle(patch_cell, 0.0, (cells_x - 1) * patch_cell, 0.0625, FixedWall{}, FreeFace{}, FreeFace{});
    State state = fill(problem, 2, [&](const Vector2& x) {
        return x.x() > patch_cell && x.x() < (cells_x - 1) * patch_cell && x.y() < 0.0625;
    });
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    work.controls.tolerance = tolerance;
    const double dt = stable_time_step(problem, state.particles).dt;
    for (int k = 0; k < steps; ++k) advance_semi_implicit_step(problem, dt, state, work);
    return work.pressure.iterations;
}

TEST(PressureBlocks, OneBlockIsTheExactInverse)
{
    EXPECT_LE(iterations(40, 1e-6, 1), 2); // single precision of the factor, and the tolerance
}

TEST(PressureBlocks, SeveralBlocksNeedFewIterations)
{
    EXPECT_LE(iterations(150, 1e-3, 1), 4);
    EXPECT_LE(iterations(150, 1e-6, 1), 9);
}

TEST(PressureBlocks, ServeManySteps)
{
    EXPECT_LE(iterations(40, 1e-3, 32), 2);
}

} // namespace
} // namespace quicksand
