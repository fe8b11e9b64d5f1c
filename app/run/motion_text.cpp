#include "app/run/motion_text.hpp"

#include "app/run/number_format.hpp"
#include "solver/base/conventions.hpp"
#include "solver/problem/motion_measures.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quicksand {

namespace {

constexpr double small_residual = 0.02; // velocity at a record's end over its peak that passes for zero [-]

} // namespace

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
    text += fmt::format("  at its end the velocity is {} m/s, the displacement {} m\n",
                        short_number(measures.residual_velocity, 2),
                        short_number(measures.residual_displacement, 2));
    if (std::abs(measures.residual_velocity) > small_residual * measures.peak_velocity)
        text += "  That velocity should be zero: the record's baseline is off; see " + remedy + "\n";
    return text;
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
