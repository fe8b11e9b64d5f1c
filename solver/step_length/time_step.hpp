// The length of a step and what limits it.
#pragma once

#include "solver/problem/problem.hpp"

#include <cmath>
#include <string>

namespace quicksand {

enum class TimeStepLimiter {
    wave,
    sound,
    vibration,
    inertia,
    own_vibration,
    shaking,
    growth,
    pressure,
    strain,
    flow,
    motion,
    output
};

struct TimeStep {
    double dt = 0.0;                                 // [s]
    TimeStepLimiter limiter = TimeStepLimiter::wave; // why it is not larger
    std::string material;                            // whose wave limits it
    TimeScheme scheme = TimeScheme::explicit_steps;  // by which it is taken
    /// Of a step that waves limit in a run of implicit ones: the implicit step in whose place it is taken
    /// because it costs less; 0: none [s].
    double replaced = 0.0;
};

const char* name_of(TimeStepLimiter limiter);
const char* name_of(TimeScheme scheme);

/// Number of equal steps over a time, none longer than dt but for rounding: a step is not split by it [-].
inline double steps_over(double time, double dt)
{
    constexpr double rounding = 1e-6; // of a step
    return std::ceil(time / dt - rounding);
}

} // namespace quicksand
