#include "app/run/motion_text.hpp"

#include "app/run/number_format.hpp"
#include "solver/base/conventions.hpp"
#include "solver/problem/motion_measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

constexpr double small_residual = 0.02; // velocity at a record's end over its peak that passes for zero [-]
constexpr double small_drift = 0.02;    // displacement at the end per period over a/omega, likewise [-]

std::string describe_rest(const MotionMeasures& measures)
{
    return fmt::format("  at its end the velocity is {} m/s, the displacement {} m\n",
                       short_number(measures.residual_velocity, 2),
                       short_number(measures.residual_displacement, 2));
}

/// What a wave that ends leaves the base with.
MotionMeasures measure_end(const SineMotion& sine)
{
    constexpr double samples_per_cycle = 400.0, most_samples = 1e6;
    SampledMotion record;
    record.interval = 1.0 / (samples_per_cycle * sine.frequency);
    const double samples = std::min(most_samples, samples_per_cycle * sine.cycles);
    for (double k = 0.0; k <= samples; k += 1.0)
        record.accelerations.push_back(base_acceleration(sine, k * record.interval));
    return measure(record);
}

std::string object_to_end(const SineMotion& sine, const MotionMeasures& measures)
{
    const double amplitude = sine.amplitude / (2.0 * std::numbers::pi * sine.frequency); // a/omega [m/s]
    if (std::abs(measures.residual_displacement) * sine.frequency <= small_drift * amplitude) return "";
    return "The base has drifted: motion.ramp_cycles and motion.ramp_down_cycles bring it back to rest";
}

std::string object_to_end(const MotionMeasures& measures, const std::string& remedy)
{
    if (std::abs(measures.residual_velocity) <= small_residual * measures.peak_velocity) return "";
    return "That velocity should be zero: the record's baseline is off; see " + remedy;
}

/// Indented, on a line of its own; "" of nothing.
std::string line_of(const std::string& text)
{
    return text.empty() ? "" : "  " + text + '\n';
}

std::string describe_end(const SineMotion& sine)
{
    if (!std::isfinite(sine.cycles)) return "";
    const MotionMeasures measures = measure_end(sine);
    return describe_rest(measures) + line_of(object_to_end(sine, measures));
}

} // namespace

std::string describe_sine(const SineMotion& sine)
{
    return fmt::format("  PGA {} g, PGV {} m/s at {} Hz{}\n", short_number(sine.amplitude / standard_gravity),
                       short_number(sine.amplitude / (2.0 * std::numbers::pi * sine.frequency)),
                       short_number(sine.frequency, 4),
                       std::isfinite(sine.cycles) ? fmt::format(", {} cycles", short_number(sine.cycles, 4))
                                                  : "") +
           describe_end(sine);
}

std::string describe_motion_measures(const SampledMotion& motion, const std::string& remedy)
{
    const MotionMeasures measures = measure(motion);
    std::string text =
        fmt::format("  PGA {} g at {} s, PGV {} m/s, PGD {} m; Arias intensity {} m/s\n"
                    "  {} s in steps of {} s, frequencies up to {} Hz; significant duration D5-95 {} s\n",
                    short_number(measures.peak_acceleration / standard_gravity),
                    short_number(measures.peak_time), short_number(measures.peak_velocity),
                    short_number(measures.peak_displacement), short_number(measures.arias_intensity),
                    short_number(duration(motion), 4), short_number(motion.interval),
                    short_number(0.5 / motion.interval), short_number(measures.significant_duration));
    return text + describe_rest(measures) + line_of(object_to_end(measures, remedy));
}

std::string warn_of_coarse_rows(const BaseMotion& motion, double interval)
{
    constexpr double coarse = 0.25; // of a period: the mean of a sine over it is 0.9 of its peak
    const double frequency = highest_frequency(motion);
    if (!(interval * frequency > coarse)) return "";
    return fmt::format(
        "Warning: probes write a row every {} s, and the motion has frequencies of {} Hz: accelerations are "
        "means from row to row and miss its peaks; output.probe_interval = {} would show them",
        short_number(interval), short_number(frequency, 2), short_number(0.1 / frequency, 1));
}

std::string warn_of_drift(const BaseMotion& motion)
{
    std::string left, objection;
    if (const auto* record = std::get_if<SampledMotion>(&motion)) {
        const MotionMeasures measures = measure(*record);
        left = fmt::format("a velocity of {} m/s", short_number(measures.residual_velocity, 2));
        objection = object_to_end(measures, "motion.baseline");
    }
    if (const auto* sine = std::get_if<SineMotion>(&motion); sine != nullptr && std::isfinite(sine->cycles)) {
        const MotionMeasures measures = measure_end(*sine);
        left = fmt::format("a displacement of {} m", short_number(measures.residual_displacement, 2));
        objection = object_to_end(*sine, measures);
    }
    return objection.empty() ? "" : "Warning: the motion leaves the base with " + left + ". " + objection;
}

std::string describe_spectrum(const std::vector<OscillatorPeaks>& spectrum, double damping)
{
    const double period = predominant_period(spectrum);
    if (period == 0.0) return "  no spectrum: the motion is silent\n";
    double largest = 0.0; // [m/s2]
    for (const OscillatorPeaks& peaks : spectrum) largest = std::max(largest, peaks.pseudo_acceleration());
    return fmt::format("  predominant period {} s, where the spectrum of {} % damping has its peak, {} g\n",
                       short_number(period), short_number(damping), short_number(largest / standard_gravity));
}

} // namespace quicksand
