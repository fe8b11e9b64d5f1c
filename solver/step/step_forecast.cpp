#include "solver/step/step_forecast.hpp"

#include "solver/step/implicit_cost.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step_length/accuracy_control.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "solver/step_length/end_of_motion.hpp"
#include "solver/step_length/histories.hpp"
#include "solver/step_length/own_vibration.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace quicksand {

namespace {

constexpr double sound_crossings = 20.0; // of the body: a run that ends by then is about sound

/// Whether the motion of the grains is all that goes on, which implicit steps would end.
bool is_about_motion(const Problem& problem, const Particles& particles)
{
    if (water_flow(problem) == WaterFlow::coupled || duration(problem.base_motion) > 0.0) return false;
    const double shear_speed = find_extremes(problem, particles).shear_speed;
    return !changes_slowly(problem, crossing_time(problem.grid, shear_speed));
}

/// Time from which implicit steps grow, where the motion and the vibration that it leaves are over [s].
double start_of_growth(const Problem& problem, const Particles& particles)
{
    if (problem.scheme != TimeScheme::implicit) return std::numeric_limits<double>::infinity();
    const CellExtremes extremes = find_extremes(problem, particles);
    const double crossing = crossing_time(problem.grid, extremes.shear_speed);
    const double end = end_of_motion(problem, crossing);
    return end > 0.0 || is_loaded_fast(problem, crossing)
               ? end + afterlife(particles, extremes.shear_slowness)
               : 0.0;
}

/// Longest step in soil that drains `since` a time: pressures change as with the root of the time [s].
double step_of_drainage(const Problem& problem, double since)
{
    return water_flow(problem) == WaterFlow::coupled ? 2.0 * pressure_change * since
                                                     : std::numeric_limits<double>::infinity();
}

/// Mean step under loads and water that vary as a sine: pressures that pass zero with it change by a part of
/// themselves in a step down to a twentieth of their peak, 4 ln(20)/part steps a period [s].
double step_of_sines(const Problem& problem)
{
    double step = std::numeric_limits<double>::infinity();
    if (water_flow(problem) != WaterFlow::coupled) return step;
    for_each_history(problem, [&](const History& history) {
        if (const auto* sine = std::get_if<SineHistory>(&history.shape))
            step = std::min(step, pressure_change / (4.0 * std::log(20.0) * sine->frequency));
    });
    return step;
}

} // namespace

std::int64_t count_steps(const Problem& problem, const Particles& particles, double dt,
                         const std::vector<double>& events)
{
    const double start = start_of_growth(problem, particles), of_sines = step_of_sines(problem);
    double steps = 0.0, time = 0.0;
    for (const double event : events) {
        if (time < start) {
            const double until = std::min(event, start);
            steps += steps_over(until - time, dt);
            time = until;
        }
        for (; time < event; ++steps) {
            const double longest = std::min({resolving_step_of_histories(problem, time),
                                             step_of_drainage(problem, time - start), of_sines});
            dt = std::min(step_growth * dt, std::max(dt, longest));
            const double left = steps_over(event - time, dt);
            time = left > 1.0 ? time + (event - time) / left : event;
        }
    }
    return static_cast<std::int64_t>(steps);
}

TimeScheme fastest_scheme(const Problem& problem, const State& state, double end_time)
{
    const Particles& particles = state.particles;
    const TimeScheme by_waves = scheme_of_waves(problem);
    if (water_flow(problem) == WaterFlow::undrained) return by_waves;
    if (end_time < sound_crossings * sound_time(problem, particles)) return TimeScheme::explicit_steps;
    if (is_about_motion(problem, particles)) return by_waves;
    const auto steps_by = [&](TimeScheme scheme) {
        Problem trial = problem;
        trial.scheme = scheme;
        return static_cast<double>(
            count_steps(trial, particles, stable_time_step(trial, particles).dt, {end_time}));
    };
    const double cost = implicit_cost(count_parts(problem, state));
    return cost * steps_by(TimeScheme::implicit) < steps_by(by_waves) ? TimeScheme::implicit : by_waves;
}

} // namespace quicksand
