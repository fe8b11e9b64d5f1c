// What limits steps that no wave does.
#include "solver/step_length/accuracy_control.hpp"
#include "solver/step_length/end_of_motion.hpp"
#include "solver/step_length/own_vibration.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

Problem under_load(const History& history)
{
    Problem problem;
    FreeFace top;
    top.load = SurfaceLoad{};
    top.load->history = history;
    problem.boundaries = rectangle(0.0, 0.0, 1.0, 1.0, FixedWall{}, RollerWall{}, top);
    return problem;
}

// The plate of Mandel's slab moves by a table whose first interval is a millionth of the whole.
TEST(AccuracyControl, ReachesIntoNoIntervalOfATableByMoreThanItsLength)
{
    const Problem problem =
        under_load({SampledHistory{{0.0, 1e-6, 0.01, 1.0, 1.1, 5.0}, {0, 1, 1, 2, 2, 0}}});
    EXPECT_DOUBLE_EQ(resolving_step(problem, 0.0), 1e-6);
    EXPECT_DOUBLE_EQ(resolving_step(problem, 1e-6), 0.01 - 1e-6);
    EXPECT_DOUBLE_EQ(resolving_step(problem, 0.5), 0.6); // 0.1 behind 1 s
    EXPECT_NEAR(resolving_step(problem, 0.95), 0.15, 1e-12);
    EXPECT_NEAR(resolving_step(problem, 1.05), 0.1, 1e-12);
    EXPECT_DOUBLE_EQ(resolving_step(problem, 2.0), 3.9);
    EXPECT_EQ(resolving_step(problem, 6.0), std::numeric_limits<double>::infinity());
}

TEST(AccuracyControl, ResolvesARampWhileItLasts)
{
    const Problem problem = under_load({ConstantHistory{}, 2.0});
    EXPECT_DOUBLE_EQ(resolving_step(problem, 1.9), 0.01);
    EXPECT_EQ(resolving_step(problem, 2.0), std::numeric_limits<double>::infinity());
}

TEST(AccuracyControl, FollowsSinesWhileTheyLast)
{
    Problem problem = under_load({SineHistory{4.0}});
    EXPECT_DOUBLE_EQ(coarsest_step(problem, 3.0), 1.0 / 80.0);
    problem.base_motion = SineMotion{1.0, 10.0, 20.0}; // 2 s
    EXPECT_DOUBLE_EQ(coarsest_step(problem, 1.9), 1.0 / 200.0);
    EXPECT_DOUBLE_EQ(coarsest_step(problem, 2.1), 1.0 / 80.0);
    EXPECT_EQ(coarsest_step(under_load({ConstantHistory{}, 2.0}), 0.0),
              std::numeric_limits<double>::infinity());
}

// Steps of a flood of days were as short as those of an earthquake.
TEST(AccuracyControl, LetsWhatRisesSlowlyMoveTheSoilWithoutWaves)
{
    const Problem ramp = under_load({ConstantHistory{}, 2.0});
    EXPECT_EQ(end_of_motion(ramp, 0.03), 2.0);
    EXPECT_EQ(end_of_motion(ramp, 0.01), 0.0);
    const Problem table = under_load({SampledHistory{{0.0, 2.0, 10.0}, {0, 1, 0}}});
    EXPECT_EQ(end_of_motion(table, 0.03), 10.0);
    EXPECT_EQ(end_of_motion(table, 0.01), 0.0);
    const Problem tide = under_load({SineHistory{0.25}}); // goes from -1 to 1 in 1.273 s as fast as at 0
    EXPECT_EQ(end_of_motion(tide, 0.0129), std::numeric_limits<double>::infinity());
    EXPECT_EQ(end_of_motion(tide, 0.0126), 0.0);
    Problem shaken = ramp;
    shaken.base_motion = SineMotion{1.0, 10.0, 20.0}; // 2 s
    EXPECT_EQ(end_of_motion(shaken, 0.01), 2.0);
}

// How often a table has rows says nothing of how fast it rises.
TEST(AccuracyControl, TellsWhatIsSlowByTheSlope)
{
    SampledHistory coarse{{0.0, 2.0, 10.0}, {0.0, 1.0, 0.0}}, fine;
    for (int k = 0; k <= 1000; ++k) {
        fine.times.push_back(0.01 * k);
        fine.values.push_back(history_value({coarse}, 0.01 * k));
    }
    for (const double crossing : {0.019, 0.021})
        EXPECT_EQ(is_slow({fine}, crossing), is_slow({coarse}, crossing)) << crossing;
    SampledHistory sine;
    for (int k = 0; k <= 2000; ++k) {
        sine.times.push_back(0.01 * k);
        sine.values.push_back(history_value({SineHistory{0.25}}, 0.01 * k));
    }
    for (const double crossing : {0.0126, 0.0129})
        EXPECT_EQ(is_slow({sine}, crossing), is_slow({SineHistory{0.25}}, crossing)) << crossing;
    EXPECT_TRUE(is_slow({SampledHistory{{0.0, 1e-3, 10.0}, {0.3, 0.3, 0.3}}}, 1.0)) << "stays as it is";
    EXPECT_FALSE(is_slow({ConstantHistory{}}, 1e-9)) << "comes at once";
}

// Free vibrations of 10 m of sand: 20 periods of 4 H / c_s are followed, unless they are small.
TEST(AccuracyControl, FollowsVibrationsThatTheMotionLeaves)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 4, 22};
    problem.materials = {stiff_sand()};
    problem.base_motion = SineMotion{1.0, 10.0, 20.0}; // 2 s
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 10.0; });
    CellExtremes extremes;
    extremes.shear_speed = 100.0;
    extremes.shear_slowness = 0.01;
    const double period = 4.0 * 10.0 * 0.01;
    const auto is_left_at = [&](double time) {
        return is_left_alone(problem, time, state.particles, extremes);
    };
    EXPECT_FALSE(is_left_at(1.99));
    EXPECT_TRUE(is_left_at(2.01)) << "at rest";
    const double of_a_millionth = 1e-6 * 2.0 * std::numbers::pi / period / std::sqrt(0.5); // xy alone [1/s]
    Scalars& shear = state.particles.affine_velocity_solid.xy;
    std::fill(shear.begin(), shear.end(), 0.99 * of_a_millionth);
    EXPECT_TRUE(is_left_at(2.01));
    std::fill(shear.begin(), shear.end(), 1.01 * of_a_millionth);
    EXPECT_FALSE(is_left_at(2.01));
    EXPECT_FALSE(is_left_at(1.99 + 20.0 * period));
    EXPECT_TRUE(is_left_at(2.01 + 20.0 * period));
}

/// Soil of 10 m, half of it of the law `other`.
double step_of_half(const SkeletonLaw& other)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 4, 22};
    problem.materials = {stiff_sand(), stiff_sand()};
    problem.materials[1].law = other;
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 10.0; });
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.material[p] = state.particles.position.y[p] < 5.0 ? 0 : 1;
    return step_of_own_vibration(problem, state.particles, 100.0);
}

TEST(AccuracyControl, FollowsTheVibrationOfABodyWhoseSoilDoesNotDampIt)
{
    const double period = 2.6125 * 10.0 / 100.0;
    EXPECT_NEAR(step_of_half(stiff_sand().law), period / 200.0, 1e-6);
    Pm4Sand sand;
    sand.relative_density = 0.5;
    EXPECT_NEAR(step_of_half(complete(sand)), period / 100.0, 1e-6);
}

TEST(AccuracyControl, GrowsStepsWhileALoadRisesSlowlyAndResolvesIt)
{
    Problem problem = under_load({ConstantHistory{}, 2e4});
    problem.grid = {{0.0, 0.0}, 0.5, 4, 4};
    problem.materials = {stiff_sand()};
    problem.scheme = TimeScheme::implicit;
    State state = fill(problem, 2, [](const Vector2& x) { return x.norm() < 1.0; });
    state.time = 1e3;
    state.whole_step = 1.0;
    EXPECT_DOUBLE_EQ(stable_time_step(problem, state, 1.0).dt, step_growth);
    state.whole_step = 1e3;
    const TimeStep longest = stable_time_step(problem, state, 1.0);
    EXPECT_DOUBLE_EQ(longest.dt, 100.0);
    EXPECT_EQ(longest.limiter, TimeStepLimiter::shaking);
}

// As after steps that the watchdog has made shorter: pressures go on at their rate in a step, and a step of
// many times the last one carried them far beyond.
TEST(AccuracyControl, GrowsFromTheLastStepHoweverShort)
{
    Problem problem = under_load({ConstantHistory{}, 0.0});
    problem.grid = {{0.0, 0.0}, 0.5, 4, 4};
    problem.materials = {stiff_sand()};
    problem.scheme = TimeScheme::implicit;
    State state = fill(problem, 2, [](const Vector2& x) { return x.norm() < 1.0; });
    const double first = stable_time_step(problem, state, 1.0).dt;
    state.whole_step = 0.01 * first;
    const TimeStep next = stable_time_step(problem, state, 1.0);
    EXPECT_DOUBLE_EQ(next.dt, step_growth * state.whole_step);
    EXPECT_EQ(next.limiter, TimeStepLimiter::growth);
}

// Soft soil in cells so wide that its waves would take longer than the load.
TEST(AccuracyControl, BoundsTheStepsOfEveryScheme)
{
    for (const TimeScheme scheme : {TimeScheme::explicit_steps, TimeScheme::implicit}) {
        Problem problem = under_load({SineHistory{1000.0}});
        problem.grid = {{0.0, 0.0}, 0.5, 4, 4};
        problem.materials = {stiff_sand()};
        problem.scheme = scheme;
        const State state = fill(problem, 2, [](const Vector2& x) { return x.norm() < 1.0; });
        const TimeStep step = stable_time_step(problem, state, 1.0);
        EXPECT_DOUBLE_EQ(step.dt, 5e-5);
        EXPECT_EQ(step.limiter, TimeStepLimiter::shaking);
    }
}

} // namespace
} // namespace quicksand
