// A little water in the cells of dry soil above a water table.
#include "solver/measure/balances.hpp"
#include "solver/run/simulation.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// Soil without stress on a fixed base between rollers, wet to a height [m], with a sloping top.
State falling_soil(double wet_to, Problem& problem)
{
    problem.grid = {{0.0, 0.0}, 0.5, 6, 6};
    Material wet = stiff_sand();
    wet.law = LinearElastic{8e6, 0.3};
    wet.hydraulic_conductivity = 1e-8;
    Material dry = wet;
    dry.saturated = false;
    problem.materials = {wet, dry};
    problem.water = water_to(wet_to);
    problem.boundaries = rectangle(0.0, 0.0, 3.0, 2.0, FixedWall{}, RollerWall{}, FreeFace{});
    State state = fill(problem, 5, [](const Vector2& x) { return x.y() < 1.2 + 0.2 * x.x(); });
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.material[p] = state.particles.position.y[p] > wet_to ? 1 : 0;
    return state;
}

// The strain of a whole cell of falling soil set the pressure of the little water in it, and made energy.
TEST(ThinWater, MakesNoEnergyBelowDrySoilThatFalls)
{
    for (const TimeScheme scheme :
         {TimeScheme::explicit_steps, TimeScheme::semi_implicit, TimeScheme::implicit}) {
        Problem problem;
        State state = falling_soil(0.6, problem);
        problem.scheme = scheme;
        open_balances(problem, state);
        run(problem, 0.005, {}, state);
        EXPECT_LT(std::abs(balance(problem, state).energy_error), 0.01) << static_cast<int>(scheme);
        double largest = 0.0, below = 0.0;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            const double pressure = std::abs(state.particles.pore_pressure[p]);
            largest = std::max(largest, pressure);
            if (state.particles.position.y[p] < 0.5) below = std::max(below, pressure);
        }
        EXPECT_LT(largest, 1.5 * below) << static_cast<int>(scheme);
    }
}

} // namespace
} // namespace quicksand
