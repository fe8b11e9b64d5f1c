#include "solver/base/phase_timers.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(PhaseTimers, GiveTimeAndInstructionsToTheirPhase)
{
    double executed = 100.0;
    PhaseTimers timers;
    timers.executed_instructions = [&] { return executed; };
    timed(timers, Phase::scatter, [&] { executed += 30.0; });
    executed += 1000.0; // between phases
    timed(timers, Phase::gather, [&] { executed += 5.0; });
    timed(timers, Phase::scatter, [&] { executed += 2.0; });
    const auto instructions = [&](Phase phase) {
        return timers.instructions[static_cast<std::size_t>(phase)];
    };
    EXPECT_EQ(instructions(Phase::scatter), 32.0);
    EXPECT_EQ(instructions(Phase::gather), 5.0);
    EXPECT_EQ(instructions(Phase::stress), 0.0);
    EXPECT_GT(timers.seconds[static_cast<std::size_t>(Phase::scatter)], 0.0);
}

TEST(PhaseTimers, CountNoInstructionsWithoutACounter)
{
    PhaseTimers timers;
    timed(timers, Phase::scatter, [] {});
    for (const double instructions : timers.instructions) EXPECT_EQ(instructions, 0.0);
}

} // namespace
} // namespace quicksand
