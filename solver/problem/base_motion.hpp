// The shaking of the base: a horizontal acceleration history.
#pragma once

#include <variant>
#include <vector>

namespace quicksand {

/// No shaking.
struct NoMotion {};

/// A sine wave for a number of cycles, its amplitude rising linearly over the first ramp cycles.
struct SineMotion {
    double amplitude = 0.0;   // a [m/s2]
    double frequency = 0.0;   // f [Hz]
    double cycles = 0.0;      // number of cycles, infinite when it never ends [-]
    double ramp_cycles = 0.0; // cycles of linear rise [-]
};

/// A record at equal time intervals, linear in between and zero outside.
struct SampledMotion {
    double interval = 0.0;             // [s]
    std::vector<double> accelerations; // [m/s2]
};

using BaseMotion = std::variant<NoMotion, SineMotion, SampledMotion>;

/// Horizontal acceleration of the base at the time after shaking began [m/s2].
double base_acceleration(const BaseMotion& motion, double time);

/// Longest step that resolves the motion: 1/200 of the period of a sine, the interval of a record; infinite
/// without motion [s].
double resolving_step(const BaseMotion& motion);

/// End of the shaking [s]; infinite for a sine wave without end.
double duration(const BaseMotion& motion);

} // namespace quicksand
