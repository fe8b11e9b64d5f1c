// The phases of a step: they name where the time goes and where a run went bad.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace quicksand {

enum class Phase { sort, scatter, momentum, gather, pore_pressure, motion, stress };

inline constexpr std::size_t phase_count = 7;

constexpr const char* name_of(Phase phase)
{
    constexpr const char* names[phase_count] = {"sort",          "scatter", "momentum", "gather",
                                                "pore_pressure", "motion",  "stress"};
    return names[static_cast<std::size_t>(phase)];
}

/// Wall time spent in each phase so far.
struct PhaseTimers {
    std::array<double, phase_count> seconds{}; // [s]
};

/// Do the work and add its wall time to the phase.
template <class Work>
void timed(PhaseTimers& timers, Phase phase, Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    timers.seconds[static_cast<std::size_t>(phase)] +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace quicksand
