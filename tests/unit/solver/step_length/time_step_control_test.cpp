#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

TEST(WaveSpeeds, OfStiffSaturatedSandAgreeWithThePublishedEigenvalues)
{
    // G = 100 MPa, nu = 0.3, n = 0.43, rho_s = 2650, K_w = 2.2 GPa
    const WaveSpeeds speeds = wave_speeds(stiff_sand(), water_to(0.0), 0.43);
    EXPECT_NEAR(speeds.undrained, 1678.0, 0.5);
    EXPECT_NEAR(speeds.fast, 1839.0, 0.5);
    EXPECT_NEAR(speeds.slow, 388.0, 0.5);
    EXPECT_NEAR(speeds.shear, 227.0, 0.5);
}

TEST(WaveSpeeds, OfDrySandAreThoseOfTheSkeleton)
{
    const WaveSpeeds speeds = wave_speeds(stiff_sand(), std::nullopt, 0.43);
    EXPECT_NEAR(speeds.skeleton, 481.0, 0.5);
    EXPECT_EQ(speeds.fast, 0.0);
}

TEST(TimeStep, IsLimitedByTheFastestMaterialAndNamesIt)
{
    Problem problem = centrifuge_column();
    Material clay = stiff_sand();
    clay.name = "clay";
    clay.law = LinearElastic{5e6, 0.3};
    problem.materials.push_back(clay);
    const State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    const TimeStep step = stable_time_step(problem, state.particles);
    EXPECT_NEAR(step.dt, 0.65 * 0.0075 / 1839.0, 2e-9);
    EXPECT_EQ(step.limiter, TimeStepLimiter::wave);
    EXPECT_EQ(step.material, "sand");
}

TEST(TimeStep, IsLimitedByFastMotion)
{
    const Problem problem = centrifuge_column();
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    state.particles.velocity_solid.x[17] = 1000.0;
    const TimeStep step = stable_time_step(problem, state.particles);
    EXPECT_DOUBLE_EQ(step.dt, 0.2 * 0.0075 / 1000.0);
    EXPECT_EQ(step.limiter, TimeStepLimiter::motion);
}

} // namespace
} // namespace quicksand
