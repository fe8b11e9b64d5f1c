#include "solver/step/step_forecast.hpp"

#include "solver/step/implicit_cost.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step_length/accuracy_control.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "solver/step_length/end_of_motion.hpp"
#include "solver/step_length/own_vibration.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double sound_crossings = 20.0; // of the body: a run that ends by then is about sound

/// In which the fastest wave crosses the body, where water flows through it; else 0 [s].
double sound_time(const Problem& problem, const Particles& particles)
{
    if (water_flow(problem) != WaterFlow::coupled) return 0.0;
    double speed = 0.0;
    for (const WaveSpeeds& waves : fastest_waves(problem, particles)) speed = std::max(speed, waves.fast);
    return body_height(particles) / speed;
}

/// Whether vibrations that nothing damps are all that goes on: implicit steps end them where nothing shakes
/// the body.
bool vibrates_alone(const Problem& problem, const Particles& particles)
{
    return water_flow(problem) != WaterFlow::coupled && duration(problem.base_motion) == 0.0 &&
           undamped_share(problem, particles) > 0.0;
}

} // namespace

std::int64_t count_steps(const Problem& problem, const Particles& particles, double dt,
                         const std::vector<double>& events)
{
    const double start_of_growth =
        problem.scheme == TimeScheme::implicit
            ? end_of_motion(problem,
                            body_times(problem, particles, find_extremes(problem, particles).shear_speed))
            : std::numeric_limits<double>::infinity();
    double steps = 0.0, time = 0.0;
    for (const double event : events) {
        if (time < start_of_growth) {
            const double until = std::min(event, start_of_growth);
            steps += steps_over(until - time, dt);
            time = until;
        }
        for (; time < event; ++steps) {
            dt = std::min(step_growth * dt, std::max(dt, resolving_step_of_histories(problem, time)));
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
    if (vibrates_alone(problem, particles)) return by_waves;
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
