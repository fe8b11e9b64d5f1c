// The inertia of implicit steps where walls are slanted and cells are cut.
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/inertia_apart.hpp"

#include <gtest/gtest.h>

#include <random>

namespace quicksand {
namespace {

using namespace fixtures;

/// A saturated column between rollers on a held base, at an angle to the grid.
AssembledCase column_at(double degrees, double conductivity)
{
    constexpr double h = 0.1;
    const std::vector<NamedCorner> column = {
        {{0.0, 0.0}, "base"}, {{0.5, 0.0}, "right"}, {{0.5, 1.0}, ""}, {{0.0, 1.0}, "left"}};
    return assemble(scene_with(h, {-1.1 + 0.3 * h, -0.3 + 0.6 * h}, 24, 21,
                               saturated_column("implicit", "large", conductivity)),
                    polygon_section(turned(column, degrees, {0.0, 0.0})));
}

/// Small velocities that change from particle to particle.
void stir(State& state)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> velocity(-1e-3, 1e-3);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double x = velocity(generator), y = velocity(generator);
        state.particles.velocity_solid.set(p, {x, y});
        state.particles.velocity_fluid.set(p, {x, y});
    }
}

// One factor has grains, water, walls and followers; the momentum balance has them node by node.
TEST(DrawnInertia, IsThatOfTheChangeOfVelocityAtAnyAngle)
{
    for (const double degrees : {0.0, 30.0, 75.0}) {
        for (const double conductivity : {1e-2, 1e-4}) {
            AssembledCase assembled = column_at(degrees, conductivity);
            const Problem& problem = assembled.problem;
            State& state = assembled.state;
            begin_shaking(problem, state);
            stir(state);
            SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
            constexpr double dt = 1e-3; // some four times that of the skeleton's waves
            for (int k = 0; k < 5; ++k) {
                advance_semi_implicit_step(problem, dt, state, work);
                EXPECT_FALSE(work.walls.rows.empty());
                EXPECT_LT(inertia_apart(problem, dt, work), 1e-3) << degrees << ' ' << conductivity;
            }
        }
    }
}

} // namespace
} // namespace quicksand
