#include "solver/step/step_forecast.hpp"

#include "solver/step/accuracy_control.hpp"
#include "solver/step/implicit_cost.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step/time_step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

std::int64_t count_steps(const Problem& problem, const Particles& particles, double dt,
                         const std::vector<double>& events)
{
    const double start_of_growth = problem.scheme == TimeScheme::implicit
                                       ? end_of_motion(problem, crossing_time(problem, 0.0, particles))
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
    if (water_flow(problem) == WaterFlow::undrained) return TimeScheme::explicit_steps;
    const auto steps_by = [&](TimeScheme scheme) {
        Problem trial = problem;
        trial.scheme = scheme;
        return static_cast<double>(
            count_steps(trial, particles, stable_time_step(trial, particles).dt, {end_time}));
    };
    const TimeScheme by_waves = scheme_of_waves(problem);
    const double cost = implicit_cost(count_parts(problem, state));
    return cost * steps_by(TimeScheme::implicit) < steps_by(by_waves) ? TimeScheme::implicit : by_waves;
}

} // namespace quicksand
