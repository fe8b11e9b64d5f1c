#include "solver/problem/base_motion.hpp"

#include "solver/base/overload.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace quicksand {

namespace {

double sine_acceleration(const SineMotion& sine, double time)
{
    const double cycle = time * sine.frequency;
    if (cycle < 0.0 || cycle > sine.cycles) return 0.0;
    const double rise = cycle < sine.ramp_cycles ? cycle / sine.ramp_cycles : 1.0;
    return rise * sine.amplitude * std::sin(2.0 * std::numbers::pi * cycle);
}

double sampled_acceleration(const SampledMotion& record, double time)
{
    const double sample = time / record.interval;
    if (!(sample >= 0.0) || record.accelerations.empty()) return 0.0;
    const auto before = static_cast<std::size_t>(sample);
    if (before + 1 >= record.accelerations.size()) {
        return before + 1 == record.accelerations.size() && sample == static_cast<double>(before)
                   ? record.accelerations.back()
                   : 0.0;
    }
    const double weight = sample - static_cast<double>(before);
    return (1.0 - weight) * record.accelerations[before] + weight * record.accelerations[before + 1];
}

} // namespace

double base_acceleration(const BaseMotion& motion, double time)
{
    return std::visit(
        Overload{[](const NoMotion&) { return 0.0; },
                 [&](const SineMotion& sine) { return sine_acceleration(sine, time); },
                 [&](const SampledMotion& record) { return sampled_acceleration(record, time); }},
        motion);
}

double resolving_step(const BaseMotion& motion)
{
    constexpr double steps_per_period = 200.0;
    return std::visit(
        Overload{[](const NoMotion&) { return std::numeric_limits<double>::infinity(); },
                 [](const SineMotion& sine) { return 1.0 / (steps_per_period * sine.frequency); },
                 [](const SampledMotion& record) { return record.interval; }},
        motion);
}

double duration(const BaseMotion& motion)
{
    return std::visit(Overload{[](const NoMotion&) { return 0.0; },
                               [](const SineMotion& sine) { return sine.cycles / sine.frequency; },
                               [](const SampledMotion& record) {
                                   return record.accelerations.empty()
                                              ? 0.0
                                              : record.interval *
                                                    static_cast<double>(record.accelerations.size() - 1);
                               }},
                      motion);
}

} // namespace quicksand
