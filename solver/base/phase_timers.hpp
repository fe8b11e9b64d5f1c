// The phases of a step: they name where the time goes and where a run failed.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>

namespace quicksand {

enum class Phase { free_field, sort, scatter, momentum, inertia, gather, pore_pressure, motion, stress };

inline constexpr std::size_t phase_count = 9;

constexpr const char* name_of(Phase phase)
{
    constexpr const char* names[phase_count] = {"free_field",    "sort",    "scatter",
                                                "momentum",      "inertia", "gather",
                                                "pore_pressure", "motion",  "stress"};
    return names[static_cast<std::size_t>(phase)];
}

/// Wall time spent in each phase so far, and the instructions where they are counted.
struct PhaseTimers {
    std::array<double, phase_count> seconds{};          // [s]
    std::array<double, phase_count> instructions{};     // [-]
    std::function<double()> executed_instructions = {}; // of the thread so far [-]; none: not counted
};

/// Do the work and add its wall time and instructions to the phase.
template <class Work>
void timed(PhaseTimers& timers, Phase phase, Work&& work)
{
    const auto k = static_cast<std::size_t>(phase);
    const auto start = std::chrono::steady_clock::now();
    if (timers.executed_instructions) timers.instructions[k] -= timers.executed_instructions();
    work();
    if (timers.executed_instructions) timers.instructions[k] += timers.executed_instructions();
    timers.seconds[k] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace quicksand
