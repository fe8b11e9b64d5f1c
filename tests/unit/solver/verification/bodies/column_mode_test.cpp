// The standing waves of a column as initial states: the same frequencies as the dispersion relation, and the
// projection that measures them.
#include "solver/verification/bodies/column_mode.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

struct Column {
    Problem problem;
    State state;
};

Column column(int cells, SoilCondition top)
{
    Column result;
    Problem& problem = result.problem;
    problem.grid = {{0.0, 0.0}, 1.0 / cells, 1, cells + 1};
    problem.materials = {stiff_sand()};
    problem.materials.front().hydraulic_conductivity = 1e-2;
    problem.water = water_to(1.0);
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, problem.grid.cell_size, 1.0, FixedWall{}, RollerWall{}, top);
    result.state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    return result;
}

TEST(Layer, IsReadOffTheParticles)
{
    const Column closed = column(8, FixedWall{});
    const Layer layer = read_layer(closed.problem, closed.state);
    EXPECT_NEAR(layer.base, 0.0, 1e-14);
    EXPECT_NEAR(layer.top, 1.0, 1e-14);
    EXPECT_NEAR(layer.soil.constrained_modulus, 350e6, 1.0);
    EXPECT_TRUE(is_closed(closed.problem, layer.top));
    EXPECT_FALSE(is_closed(column(8, FreeFace{}).problem, layer.top));
}

TEST(ColumnMode, HasTheFrequenciesOfTheDispersionRelation)
{
    const Column closed = column(8, FixedWall{});
    const Layer layer = read_layer(closed.problem, closed.state);
    const double xi = 2.0 * std::numbers::pi;
    const LongitudinalModes exact = longitudinal_modes(layer.soil, xi);
    for (const Complex s : {exact.fast, exact.slow}) {
        EXPECT_NEAR(std::abs(column_mode(layer, xi, s).s / s - 1.0), 0.0, 1e-10);
    }
}

TEST(ColumnMode, IsMeasuredAsItWasStartedAndAloneAmongTheModes)
{
    Column closed = column(8, FixedWall{});
    const Layer layer = read_layer(closed.problem, closed.state);
    const double xi = 2.0 * std::numbers::pi;
    const LongitudinalModes exact = longitudinal_modes(layer.soil, xi);
    const ColumnMode fast = column_mode(layer, xi, exact.fast), slow = column_mode(layer, xi, exact.slow);
    start_mode(fast, closed.state.particles);
    EXPECT_NEAR(std::abs(measure_start(fast, closed.state.particles) - 0.5), 0.0, 1e-10);
    EXPECT_NEAR(std::abs(measure_start(slow, closed.state.particles)), 0.0, 1e-10);
}

TEST(ColumnMode, PropagatesWithTheDispersionOfBilinearCells)
{
    const Column closed = column(10, FixedWall{});
    const Layer layer = read_layer(closed.problem, closed.state);
    const double xi = 2.0 * std::numbers::pi;
    const ColumnMode slow = column_mode(layer, xi, longitudinal_modes(layer.soil, xi).slow);
    const Complex s = propagated_frequency(closed.problem, layer, slow, closed.state, 2e-3);
    // lumped masses: a wave of this number is slower by (xi h)^2 / 24, and decays as it should
    EXPECT_NEAR(1.0 - s.imag() / slow.s.imag(), std::pow(0.1 * xi, 2) / 24.0, 5e-4);
    EXPECT_NEAR(s.real() / slow.s.real(), 1.0, 1e-4);
}

TEST(ColumnMode, FindsTheFrequencyOfAKnownGrowth)
{
    const Column closed = column(8, FixedWall{});
    const Layer layer = read_layer(closed.problem, closed.state);
    const double xi = 2.0 * std::numbers::pi, duration = 1e-3;
    const ColumnMode slow = column_mode(layer, xi, longitudinal_modes(layer.soil, xi).slow);
    const Complex s = slow.s * Complex(1.02, 0.01);
    const Complex measured = measured_frequency(slow, 0.5, 0.5 * std::exp(s * duration), duration);
    EXPECT_NEAR(std::abs(measured / s - 1.0), 0.0, 1e-12);
}

} // namespace
} // namespace quicksand
