#include "solver/step/step_forecast.hpp"
#include "solver/step_length/accuracy_control.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "solver/step_length/own_vibration.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

namespace quicksand {
namespace {

using namespace fixtures;

/// Four cells of 1 m of sand in a box.
Problem box_of_sand(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 2, 3};
    problem.materials = {stiff_sand()};
    if (saturated) problem.water = water_to(2.0);
    problem.boundaries = rectangle(0.0, 0.0, 2.0, 2.0, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

State state_of(const Problem& problem)
{
    return fill(problem, 2, [](const Vector2& x) { return x.y() < 2.0; });
}

Particles sand_of(const Problem& problem)
{
    return state_of(problem).particles;
}

SineMotion sine_of(double frequency, double cycles)
{
    SineMotion sine;
    sine.amplitude = 1.0;
    sine.frequency = frequency;
    sine.cycles = cycles;
    return sine;
}

} // namespace

TEST(StepForecast, StepsHitEveryEvent)
{
    Problem problem = box_of_sand(true);
    problem.scheme = TimeScheme::semi_implicit;
    EXPECT_EQ(count_steps(problem, sand_of(problem), 0.25, {1.0}), 4);
    EXPECT_EQ(count_steps(problem, sand_of(problem), 0.3, {1.0}), 4);
    EXPECT_EQ(count_steps(problem, sand_of(problem), 0.3, {0.5, 1.0}), 4);
    EXPECT_EQ(count_steps(problem, sand_of(problem), 0.3, {0.5, 0.7, 1.0}), 4);
}

TEST(StepForecast, ImplicitStepsGrowWhenTheMotionIsOver)
{
    Problem problem = box_of_sand(false);
    problem.scheme = TimeScheme::implicit;
    problem.base_motion = sine_of(1.0, 2.0); // for 2 s
    const Particles sand = sand_of(problem);
    const double slowness = find_extremes(problem, sand).shear_slowness;
    const double shaken = std::ceil((2.0 + afterlife(sand, slowness)) / 0.01);
    EXPECT_EQ(count_steps(problem, sand, 0.01, {2.0}), 200);
    // dt (1.1 + 1.1^2 + ... + 1.1^n) = 11 dt (1.1^n - 1) reaches 1e6 dt
    const double growing = std::ceil(std::log(1e6 / 11.0 + 1.0) / std::log(step_growth));
    const auto steps = static_cast<double>(count_steps(problem, sand, 0.01, {2.0, 1e4 + 2.0}));
    EXPECT_GE(steps, shaken + growing);
    EXPECT_LE(steps, shaken + 1.0 + growing) << "each is shortened a little to hit the end";
}

// Steps of a fortieth of the time since the end of the motion: ln(1e4) / ln(1 + 1/40) from 1 s to 1e4 s.
TEST(StepForecast, ImplicitStepsFollowSoilThatDrains)
{
    Problem problem = box_of_sand(true);
    problem.scheme = TimeScheme::implicit;
    const Particles sand = sand_of(problem);
    const auto to_a_second = static_cast<double>(count_steps(problem, sand, 1e-3, {1.0}));
    const auto on = static_cast<double>(count_steps(problem, sand, 1e-3, {1.0, 1e4})) - to_a_second;
    EXPECT_NEAR(on, std::log(1e4) / std::log(1.0 + 2.0 * pressure_change), 5.0);
}

// A column of 628 particles took 2,000 steps in two periods of 600 s, ground under a tide 2,337 in 1.9.
TEST(StepForecast, ImplicitStepsFollowPressuresThatPassZeroWithASlowSine)
{
    Problem problem = box_of_sand(true);
    problem.scheme = TimeScheme::implicit;
    for (Boundary& boundary : problem.boundaries)
        if (auto* face = std::get_if<FreeFace>(&boundary.soil))
            face->load = SurfaceLoad{Vector2::Zero(), 1e3, {SineHistory{1.0 / 600.0}}};
    EXPECT_NEAR(static_cast<double>(count_steps(problem, sand_of(problem), 1e-3, {1200.0})), 2000.0, 250.0);
}

TEST(StepForecast, ImplicitStepsAreTakenWhereTheyAreFewEnough)
{
    for (const bool saturated : {false, true}) {
        Problem problem = box_of_sand(saturated);
        const State state = state_of(problem);
        const TimeScheme by_waves = saturated ? TimeScheme::semi_implicit : TimeScheme::explicit_steps;
        problem.base_motion = sine_of(1.0, 10.0);
        EXPECT_EQ(fastest_scheme(problem, state, 1e3), TimeScheme::implicit);
        problem.base_motion = sine_of(100.0, 10.0); // 1/200 of a period is shorter than what waves allow
        EXPECT_EQ(fastest_scheme(problem, state, 0.1), by_waves);
        EXPECT_EQ(fastest_scheme(problem, state, 1e4), TimeScheme::implicit) << "consolidation";
    }
}

TEST(StepForecast, SoundIsFollowedByExplicitSteps)
{
    const Problem problem = box_of_sand(true);
    const State state = state_of(problem);
    EXPECT_EQ(fastest_scheme(problem, state, 1e-2),
              TimeScheme::explicit_steps); // it crosses in a millisecond
    EXPECT_EQ(fastest_scheme(problem, state, 0.05), TimeScheme::semi_implicit);
}

// Steps that grow end motion.
TEST(StepForecast, TheMotionOfDrySoilIsComputedByExplicitSteps)
{
    Problem problem = box_of_sand(false);
    FreeFace top;
    top.load = SurfaceLoad{};
    problem.boundaries[2].soil = top;
    EXPECT_EQ(fastest_scheme(problem, state_of(problem), 1e4), TimeScheme::explicit_steps);
    top.load->history.ramp_time = 1e3;
    problem.boundaries[2].soil = top;
    EXPECT_EQ(fastest_scheme(problem, state_of(problem), 1e4), TimeScheme::implicit) << "it rises slowly";
    problem.boundaries[2].soil = FreeFace{};
    problem.base_motion = sine_of(1.0, 10.0);
    EXPECT_EQ(fastest_scheme(problem, state_of(problem), 1e4), TimeScheme::implicit);
}

TEST(StepForecast, UndrainedSoilIsComputedByExplicitSteps)
{
    Problem problem = box_of_sand(true);
    problem.water->flow = WaterFlow::undrained;
    EXPECT_EQ(fastest_scheme(problem, state_of(problem), 1e4), TimeScheme::explicit_steps);
}

} // namespace quicksand
