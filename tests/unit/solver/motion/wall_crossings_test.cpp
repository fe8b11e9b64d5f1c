// Centres of domains stay before standing walls.
#include "solver/motion/wall_crossings.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// A box of 4 x 3 m with a wall at the base, rollers at the sides and an open top.
Problem box()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 5, 5};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 4.0, 3.0, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

TEST(WallCrossings, StopsCentresOnTheWall)
{
    const Problem problem = box();
    struct Row {
        Vector2 after, velocity, expected;
    };
    const Row rows[] = {
        {{-0.1, 1.5}, {-1.0, 0.5}, {1e-6, 1.5}},     // through the left side
        {{4.2, 1.5}, {1.0, 0.0}, {4.0 - 1e-6, 1.5}}, // through the right one
        {{2.0, -0.3}, {0.0, -1.0}, {2.0, 1e-6}},     // through the base
        {{0.1, 1.5}, {-1.0, 0.0}, {0.1, 1.5}},       // before the wall
        {{2.0, 3.2}, {0.0, 1.0}, {2.0, 3.2}},        // through the free face
        {{-0.1, 3.4}, {-1.0, 0.0}, {-0.1, 3.4}},     // above the end of the wall
        {{-1.5, 1.5}, {-1.0, 0.0}, {-1.5, 1.5}},     // beyond it before the step as well
    };
    for (const Row& row : rows) {
        Particles particles;
        resize(particles, 1, std::nullopt);
        particles.position.set(0, row.after);
        Vectors velocity = particles.position;
        velocity.set(0, row.velocity);
        stop_at_walls(problem, 1.0, velocity, particles);
        EXPECT_NEAR((particles.position[0] - row.expected).norm(), 0.0, 1e-15) << row.after.transpose();
    }
}

} // namespace
} // namespace quicksand
