// How a load or a motion of a boundary varies with time: a factor on its value.
#pragma once

#include <variant>
#include <vector>

namespace quicksand {

/// The factor is 1.
struct ConstantHistory {
    bool operator==(const ConstantHistory&) const = default;
};

/// The factor is sin(2 pi f t).
struct SineHistory {
    double frequency = 0.0; // f [Hz]

    bool operator==(const SineHistory&) const = default;
};

/// A table of times and factors, linear in between and constant before its first and after its last time; of
/// one that goes on from earlier, times before 0 tell how.
struct SampledHistory {
    std::vector<double> times;  // increasing [s]
    std::vector<double> values; // factors [-]

    bool operator==(const SampledHistory&) const = default;
};

/// A shape that rises linearly from nothing over `ramp_time`.
struct History {
    std::variant<ConstantHistory, SineHistory, SampledHistory> shape = ConstantHistory{};
    double ramp_time = 0.0; // 0: at once; not for a table, which holds its own rise [s]
    double begun = 0.0;     // of a sine: the time that had passed at t = 0 [s]

    bool operator==(const History&) const = default;
};

/// The factor at a time; before its begin that of its begin [-].
double history_value(const History& history, double time);

/// The integral of the factor from 0 to a time, as if what has no begin had always been so [s].
double history_integral(const History& history, double time);

/// The history as one sees it that begins to count at a time: factor(t) = factor of `history` at time + t; of
/// what was before, the last straight piece.
History history_from(const History& history, double time);

/// Times up to an end at which the factor may be at its largest or smallest, the end among them [s].
std::vector<double> turning_times(const History& history, double end);

/// Whether the factor changes after t = 0.
bool varies(const History& history);

/// Largest absolute factor of the history [-].
double peak_value(const History& history);

} // namespace quicksand
