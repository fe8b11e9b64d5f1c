// The order in time of the step, with steps of changing length.
#include "solver/step/single_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

/// Displacement amplitude after 3.3 periods of an undrained wave between walls 1 m apart, with steps that
/// follow its swing by 40 % about `mean`, as a step does that follows the soil's stiffness [m].
double amplitude_with_uneven_steps(double mean)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.1, 1, 10};
    problem.materials = {stiff_sand()};
    problem.water = water_to(1.0);
    problem.water->flow = WaterFlow::undrained;
    problem.gravity = 0.0;
    problem.strain = StrainForm::small;
    problem.boundaries = rectangle(0.0, 0.0, 0.1, 1.0, FixedWall{}, RollerWall{}, FixedWall{});
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    Particles& particles = state.particles;
    const auto shape = [&](std::size_t p) {
        return std::sin(std::numbers::pi * particles.reference_position.y[p]);
    };
    for (std::size_t p = 0; p < particles.size(); ++p) particles.velocity_solid.y[p] = shape(p);

    const double speed = wave_speeds(problem.materials[0], problem.water, 0.43).undrained;
    const double end = 3.3 * 2.0 / speed;
    SinglePhaseWorkspace work = make_single_phase_workspace(problem);
    work.null_space_time = 1e9; // no damping
    while (state.time < end) {
        const double uneven = mean * (1.0 + 0.4 * std::sin(2.0 * std::numbers::pi * speed * state.time));
        advance_single_phase_step(problem, std::min(uneven, end - state.time), 0.0, state, work);
    }
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        sum += shape(p) * (particles.position.y[p] - particles.reference_position.y[p]);
    return 2.0 * sum / static_cast<double>(particles.size());
}

TEST(TimeOrder, IsTwoWithStepsThatChangeTheirLength)
{
    const double step = 2e-5, exact = amplitude_with_uneven_steps(step / 64.0);
    const double coarse = std::abs(amplitude_with_uneven_steps(step) - exact),
                 fine = std::abs(amplitude_with_uneven_steps(step / 4.0) - exact);
    EXPECT_GT(0.5 * std::log2(coarse / fine), 1.9);
}

} // namespace
} // namespace quicksand
