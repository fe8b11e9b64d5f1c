// Soil in equilibrium stays at rest.
#include "tests/fixtures/grain_speed.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace quicksand {
namespace {

using namespace fixtures;

/// Steps of the run and nothing else.
class CountSteps : public Observer {
public:
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override { steps = report.step; }
    std::int64_t steps = 0;
};

TEST(Rest, LevelColumnUnderK0StaysAtRestFor10000Steps)
{
    const Problem problem = centrifuge_column();
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    ASSERT_EQ(state.particles.size(), 3429u);
    set_level_ground_stress(problem, 0.3175, 0.5, state);

    const double dt = stable_time_step(problem, state.particles).dt;
    CountSteps steps;
    run(problem, 10'000.0 * dt, {&steps}, state);

    EXPECT_GE(steps.steps, 10'000);
    const double reference_speed = std::sqrt(problem.gravity * 0.3175);
    EXPECT_LT(largest_speed_of_grains(state.particles), 1e-8 * reference_speed);
    // the pressure as a whole is the static pressure of the still water
    const double base_pressure = problem.water->density * problem.gravity * 0.3175;
    for (const double excess : state.particles.pore_pressure)
        EXPECT_LT(std::abs(excess), 1e-3 * base_pressure);
}

/// The paper's slope: 64 x 41 cells of 7.5 mm, about 14,600 particles, under water.
Problem submerged_dike()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.0075, 64, 41};
    problem.materials = {stiff_sand()};
    problem.water = water_to(0.30);
    problem.gravity = 120.0 * standard_gravity;
    const WaterCondition drained = Drained{}, impervious = Impervious{};
    problem.boundaries = {
        {"base", FixedWall{}, impervious, {{{0.0, 0.0}, {0.48, 0.0}}}},
        {"right", RollerWall{}, impervious, {{{0.48, 0.0}, {0.48, 0.10}}}},
        {"surface",
         FreeFace{},
         drained,
         {{{0.48, 0.10}, {0.4272, 0.10}}, {{0.4272, 0.10}, {0.15, 0.25}}, {{0.15, 0.25}, {0.0, 0.25}}}},
        {"left", RollerWall{}, impervious, {{{0.0, 0.25}, {0.0, 0.0}}}}};
    return problem;
}

constexpr int slope_rest_steps = 500; // for 100 000 see examples/verification/README.md

/// Elevation of the slope's surface at x [m].
double slope_surface(double x)
{
    if (x <= 0.15) return 0.25;
    return x >= 0.4272 ? 0.10 : 0.25 - 0.15 * (x - 0.15) / (0.4272 - 0.15);
}

TEST(Rest, DikeSettlesInTheGravityStageAndStaysAtRestAfterwards)
{
    Problem problem = submerged_dike();
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < slope_surface(x.x()); });
    const Material& sand = problem.materials[0];
    const double unit_weight = (1.0 - sand.porosity) * (sand.grain_density - 1000.0) * problem.gravity;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 x = state.particles.position[p];
        state.particles.stress.yy[p] = -unit_weight * (slope_surface(x.x()) - x.y());
        state.particles.stress.xx[p] = state.particles.stress.zz[p] = 0.5 * state.particles.stress.yy[p];
    }
    const RelaxationReport report = relax(problem, {}, state);
    EXPECT_LE(report.unbalanced.of_weight, 1e-6);

    for (const TimeScheme scheme : {TimeScheme::explicit_steps, TimeScheme::semi_implicit}) {
        problem.scheme = scheme;
        State shaken = state;
        const double dt = stable_time_step(problem, state.particles).dt;
        double fastest = 0.0;
        for (int part = 1; part <= 10; ++part) {
            run(problem, part * slope_rest_steps / 10 * dt, {}, shaken);
            fastest = std::max(fastest, largest_speed_of_grains(shaken.particles));
        }
        EXPECT_LT(fastest, 1e-5 * std::sqrt(problem.gravity * 0.25));
    }
}

} // namespace
} // namespace quicksand
