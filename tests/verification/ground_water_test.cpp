// Soil with a phreatic line inside, and layered soil: at rest where it is level, seeping where it is not.
#include "solver/measure/balances.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// A column of 3 x 12 cells of 0.5 m under 1 g, one material below the other.
struct LayeredColumn {
    Problem problem;
    std::vector<double> lower_edge; // of the layers, material by material, from the top down [m]
};

constexpr double column_height = 6.0; // [m]

Problem column_problem(double level)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 3, 14};
    problem.materials = {stiff_sand()};
    problem.water = water_to(level);
    problem.boundaries = rectangle(0.0, 0.0, 1.5, column_height, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

/// Weight per volume that the grains carry [N/m3].
double carried_weight(const Problem& problem, const Material& material)
{
    const double buoyancy = material.saturated ? problem.water->density : 0.0;
    return (1.0 - material.porosity) * (material.grain_density - buoyancy) * problem.gravity;
}

/// Particles of the column in layers from the top down, under K0 = 0.5.
State layered_state(const LayeredColumn& column)
{
    const Problem& problem = column.problem;
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < column_height; });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        double vertical = 0.0, top = column_height;
        std::size_t layer = 0;
        for (;; ++layer) {
            const double weight = carried_weight(problem, problem.materials[layer]);
            const double bottom = column.lower_edge[layer];
            vertical += weight * (top - std::max(bottom, y));
            if (y > bottom) break;
            top = bottom;
        }
        const Material& material = problem.materials[layer];
        particles.material[p] = static_cast<std::int32_t>(layer);
        particles.mass_solid[p] = (1.0 - material.porosity) * material.grain_density * particles.volume[p];
        particles.porosity[p] = material.porosity;
        particles.stress.yy[p] = -vertical;
        particles.stress.xx[p] = particles.stress.zz[p] = -0.5 * vertical;
    }
    begin_shaking(state);
    return state;
}

Material with_porosity(double porosity, bool saturated)
{
    Material material = stiff_sand();
    material.porosity = porosity;
    material.saturated = saturated;
    return material;
}

double largest_speed_of_phases(const Particles& particles)
{
    double largest = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        largest =
            std::max({largest, particles.velocity_solid[p].norm(), velocity_of_water(particles, p).norm()});
    return largest;
}

/// Largest speed after `steps` steps, relative to sqrt(g H) [-].
double speed_at_rest(const LayeredColumn& column, int steps)
{
    State state = layered_state(column);
    const double dt = stable_time_step(column.problem, state.particles).dt;
    run(column.problem, steps * dt, {}, state);
    return largest_speed_of_phases(state.particles) / std::sqrt(column.problem.gravity * column_height);
}

constexpr int level_rest_steps = 5000; // for 100 000 see examples/verification/README.md

class RestOfLevelGround : public testing::TestWithParam<TimeScheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, RestOfLevelGround,
                         testing::Values(TimeScheme::explicit_steps, TimeScheme::semi_implicit));

TEST_P(RestOfLevelGround, OneSoil)
{
    LayeredColumn column{column_problem(column_height), {0.0}};
    column.problem.scheme = GetParam();
    EXPECT_LT(speed_at_rest(column, level_rest_steps), 1e-8);
}

TEST_P(RestOfLevelGround, LayersOfDifferentPorosity)
{
    LayeredColumn column{column_problem(column_height),
                         {4.0, 13.0 / 6.0, 0.0}}; // on the edges of cells and of particles
    column.problem.materials = {with_porosity(0.5, true), with_porosity(0.35, true),
                                with_porosity(0.45, true)};
    column.problem.scheme = GetParam();
    EXPECT_LT(speed_at_rest(column, level_rest_steps), 1e-8);
}

/// How a scene solves for its water.
struct Solution {
    WaterFlow flow;
    TimeScheme scheme;
};

class RestWithAPhreaticLine : public testing::TestWithParam<Solution> {
protected:
    /// The water stands at 3 m and is counted from `level`.
    LayeredColumn column(double level) const
    {
        LayeredColumn column{column_problem(level), {3.0, 0.0}};
        column.problem.materials = {with_porosity(0.43, false), with_porosity(0.43, true)};
        column.problem.water->rises_above_level = level < 3.0;
        column.problem.water->flow = GetParam().flow;
        column.problem.scheme = GetParam().scheme;
        return column;
    }
};

INSTANTIATE_TEST_SUITE_P(Solutions, RestWithAPhreaticLine,
                         testing::Values(Solution{WaterFlow::coupled, TimeScheme::explicit_steps},
                                         Solution{WaterFlow::coupled, TimeScheme::semi_implicit},
                                         Solution{WaterFlow::undrained, TimeScheme::explicit_steps},
                                         Solution{WaterFlow::drained, TimeScheme::explicit_steps}));

TEST_P(RestWithAPhreaticLine, LevelColumnStaysAtRest)
{
    EXPECT_LT(speed_at_rest(column(3.0), level_rest_steps / 2), 1e-8);
}

TEST_P(RestWithAPhreaticLine, WaterStandsAboveTheLevelOfTheScene)
{
    // the same column, its water counted from a level below: total pressures above it, water with its weight
    const LayeredColumn column = this->column(1.0);
    State state = layered_state(column);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double y = state.particles.position.y[p];
        if (state.particles.material[p] == 1)
            state.particles.pore_pressure[p] = 1000.0 * standard_gravity * (3.0 - std::max(y, 1.0));
    }
    EXPECT_LT(out_of_balance(column.problem, state), 1e-12);
    const double dt = stable_time_step(column.problem, state.particles).dt;
    open_balances(column.problem, state);
    run(column.problem, level_rest_steps / 2 * dt, {}, state);
    // the pressure's slope has a kink at the level, which the cells see rounded: 4e-7 measured
    EXPECT_LT(largest_speed_of_phases(state.particles), 1e-6 * std::sqrt(standard_gravity * column_height));
    const BalanceErrors balances = balance(column.problem, state);
    double mass = 0.0;
    for (const double m : state.particles.mass_solid) mass += m;
    EXPECT_LT(std::abs(balances.momentum_error_y), 1e-12 * mass * standard_gravity * state.time);
    EXPECT_LT(std::abs(balances.water_error), 1e-11);
}

} // namespace
} // namespace quicksand
