// The length of a step and what limits it.
#pragma once

#include <cmath>
#include <string>

namespace quicksand {

enum class TimeStepLimiter {
    wave,
    sound,
    vibration,
    inertia,
    shaking,
    growth,
    pressure,
    strain,
    motion,
    output
};

struct TimeStep {
    double dt = 0.0;                                 // [s]
    TimeStepLimiter limiter = TimeStepLimiter::wave; // why it is not larger
    std::string material;                            // whose wave limits it
};

const char* name_of(TimeStepLimiter limiter);

/// Number of equal steps over a time, none longer than dt but for rounding: a step is not split by it [-].
inline double steps_over(double time, double dt)
{
    constexpr double rounding = 1e-6; // of a step
    return std::ceil(time / dt - rounding);
}

} // namespace quicksand
