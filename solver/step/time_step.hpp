// The length of a step and what limits it.
#pragma once

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

} // namespace quicksand
