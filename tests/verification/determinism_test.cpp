// The same bits for any number of threads, and from a copy of the state taken in mid-run.
#include "solver/base/threads.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

Problem shaken_block(TimeScheme scheme = TimeScheme::explicit_steps)
{
    Problem problem;
    problem.scheme = scheme;
    problem.grid = {{0.0, 0.0}, 0.05, 24, 16};
    problem.materials = {stiff_sand()};
    problem.water = water_to(1.0);
    problem.base_motion = SineMotion{400.0, 60.0, 100.0, 0.0};
    problem.boundaries = rectangle(0.1, 0.0, 1.1, 0.6, FixedWall{}, FreeFace{}, FreeFace{});
    return problem;
}

State block_state(const Problem& problem)
{
    return fill(problem, 3, [](const Vector2& x) { return x.x() > 0.1 && x.x() < 1.1 && x.y() < 0.6; });
}

void expect_same_bits_of_threads(TimeScheme scheme, double end)
{
    const Problem problem = shaken_block(scheme);
    const int threads_before = thread_count();
    set_thread_count(1);
    State reference = block_state(problem);
    run(problem, end, {}, reference);
    for (const int threads : {2, 4}) {
        set_thread_count(threads);
        State state = block_state(problem);
        run(problem, end, {}, state);
        EXPECT_EQ(state.step, reference.step);
        expect_same_bits(state.particles, reference.particles);
    }
    set_thread_count(threads_before);
}

TEST(Determinism, OneTwoAndFourThreadsGiveTheSameBits)
{
    expect_same_bits_of_threads(TimeScheme::explicit_steps, 0.004);
}

// Two tasks at the same time set up the equations of implicit steps.
TEST(Determinism, OneTwoAndFourThreadsGiveTheSameBitsInImplicitSteps)
{
    expect_same_bits_of_threads(TimeScheme::semi_implicit, 0.004);
    expect_same_bits_of_threads(TimeScheme::implicit, 0.02);
}

TEST(Determinism, ACopyTakenInMidRunGoesOnWithTheSameBits)
{
    const Problem problem = shaken_block();
    State uninterrupted = block_state(problem);
    State interrupted = uninterrupted;
    run(problem, 0.004, {}, uninterrupted);

    const auto stop = [&] { return interrupted.step >= 137; };
    run(problem, 0.004, {}, interrupted, stop);
    ASSERT_LT(interrupted.time, 0.004);
    State copy = interrupted;
    run(problem, 0.004, {}, copy);
    EXPECT_EQ(copy.step, uninterrupted.step);
    EXPECT_EQ(copy.time, uninterrupted.time);
    expect_same_bits(copy.particles, uninterrupted.particles);
}

TEST(Determinism, ABoxOfUbcsandGoesOnFromACopyWithTheSameBits)
{
    const SandBox box;
    const Problem problem = make_problem(box);
    State uninterrupted = make_state(box, problem);
    State interrupted = uninterrupted;
    run(problem, 0.5, {}, uninterrupted);
    const auto stop = [&] { return interrupted.step >= 7000; };
    run(problem, 0.5, {}, interrupted, stop);
    ASSERT_LT(interrupted.time, 0.5);
    State copy = interrupted;
    run(problem, 0.5, {}, copy);
    expect_same_bits(copy.particles, uninterrupted.particles);
    const Scalars& half_cycles = copy.particles.memory[column_of(memory_of(UbcSand()), "half_cycles")];
    EXPECT_GT(*std::max_element(half_cycles.begin(), half_cycles.end()), 0.0);
}

} // namespace
} // namespace quicksand
