// The pressure's preconditioner knows walls and badly filled cells: bodies that lie across the grid cost no
// more iterations than those along it.
#include "solver/step/time_step_control.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// The most iterations in a few steps of a column under an uneven motion, each with blocks of its own.
int most_iterations(double degrees)
{
    const double h = 0.1;
    const auto corners =
        turned({{{0.0, 0.0}, "base"}, {{0.6, 0.0}, "right"}, {{0.6, 1.0}, "top"}, {{0.0, 1.0}, "left"}},
               degrees, {0.03, 0.0});
    AssembledCase assembled =
        assemble(scene_with(h, {-1.0, -0.3}, 20, 20, saturated_column("semi_implicit", "large", 1e-4)),
                 polygon_section(corners));
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 x = state.particles.position[p];
        const Vector2 v(1e-3 * std::sin(9.0 * x.x() + 4.0 * x.y()),
                        1e-3 * std::cos(7.0 * x.x() - 5.0 * x.y()));
        state.particles.velocity_solid.set(p, v);
        state.particles.velocity_fluid.set(p, v);
    }
    SemiImplicitWorkspace work = make_semi_implicit_workspace(assembled.problem);
    work.controls.tolerance = 1e-3;
    const double dt = stable_time_step(assembled.problem, state.particles).dt;
    int most = 0;
    for (int step = 0; step < 20; ++step) {
        work.pressure.blocks_are_due = true;
        advance_semi_implicit_step(assembled.problem, dt, state, work);
        most = std::max(most, work.pressure.iterations);
    }
    return most;
}

TEST(PressureBlocks, KnowWallsAndBadlyFilledCells)
{
    for (const double degrees : {3.0, 30.0, 45.0, 71.0}) EXPECT_LE(most_iterations(degrees), 2) << degrees;
    EXPECT_LE(most_iterations(0.0), 3); // a whole side of badly filled cells
}

} // namespace
} // namespace quicksand
