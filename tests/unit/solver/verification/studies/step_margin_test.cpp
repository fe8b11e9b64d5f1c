// The measured largest stable step: where it lies, and that it follows the step that is taken.
#include "solver/run/simulation.hpp"
#include "solver/verification/studies/step_margin.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// A block of 4 x 3 cells of 0.5 m on a fixed base between rollers.
Problem block(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 4, 3};
    problem.materials = {stiff_sand()};
    if (saturated) problem.water = water_to(1.5);
    problem.boundaries = rectangle(0.0, 0.0, 2.0, 1.5, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

double margin_of(const Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    set_level_ground_stress(problem, 1.5, 0.5, state);
    begin_shaking(problem, state);
    return step_margin(problem, state);
}

TEST(StepMargin, OfABlockIsAboveOneAndBelowTwo)
{
    for (const bool saturated : {false, true}) {
        const double margin = margin_of(block(saturated));
        EXPECT_GT(margin, 1.0) << saturated;
        EXPECT_LT(margin, 2.0) << saturated;
    }
}

TEST(StepMargin, IsHalfForTwiceTheStepAndTwiceForHalfOfIt)
{
    Problem problem = block(false);
    const double margin = margin_of(problem);
    for (const double fraction : {0.5, 2.0}) {
        problem.step_fraction = fraction;
        EXPECT_NEAR(margin_of(problem) * fraction, margin, 0.04 * margin) << fraction;
    }
}

} // namespace
} // namespace quicksand
