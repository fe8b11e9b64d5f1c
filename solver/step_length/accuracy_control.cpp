#include "solver/step_length/accuracy_control.hpp"

#include "solver/base/overload.hpp"
#include "solver/inertia/inertia_solve.hpp"
#include "solver/step_length/end_of_motion.hpp"
#include "solver/step_length/flowing_soil.hpp"
#include "solver/step_length/histories.hpp"
#include "solver/step_length/own_vibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace quicksand {

namespace {

// Of the dike under 20 g, steps twice as long take a quarter off the crest's settlement: sand in failure is
// far softer than the elastic stiffness that resists its accelerations.
constexpr double smoothed_cells = 1.0;     // over which accelerations are smoothed [-]
constexpr double steps_per_period = 200.0; // of a sine
constexpr double least_steps_per_period = 20.0;
constexpr double strain_change = 0.05;   // in a step, of the particle that is strained fastest
constexpr double least_pressure = 0.005; // that counts as the largest one, of the largest sigma'_v0

/// The step that reaches into no interval of a table by more than its length [s].
double resolving_step(const SampledHistory& table, double time)
{
    const std::vector<double>& times = table.times;
    double step = std::numeric_limits<double>::infinity();
    const auto after = std::upper_bound(times.begin(), times.end(), time) - times.begin();
    for (auto k = static_cast<std::size_t>(std::max(after, decltype(after){1}));
         k < times.size() && times[k - 1] - time < step; ++k)
        step = std::min(step, std::max(0.0, times[k - 1] - time) + times[k] - times[k - 1]);
    return step;
}

double resolving_step(const History& history, double time)
{
    const double of_ramp = history.begun + time < history.ramp_time ? history.ramp_time / steps_per_period
                                                                    : std::numeric_limits<double>::infinity();
    return std::visit(Overload{[&](const ConstantHistory&) { return of_ramp; },
                               [&](const SineHistory& sine) {
                                   return std::min(of_ramp, 1.0 / (steps_per_period * sine.frequency));
                               },
                               [&](const SampledHistory& table) { return resolving_step(table, time); }},
                      history.shape);
}

/// The step in which no particle is strained more than it may: accelerations of grains that leave the body
/// are resisted by the stiffness of cells that they do not fill [s].
double strain_step(const Particles& particles)
{
    const Gradients& L = particles.affine_velocity_solid;
    double fastest = 0.0; // squared
    for (std::size_t p = 0; p < particles.size(); ++p) fastest = std::max(fastest, rate_squared(L, p));
    return strain_change / std::sqrt(fastest);
}

/// The step in which pore pressures change as much as they may [s].
double pressure_step(const Particles& particles)
{
    const Scalars& rate = particles.pore_pressure_rate;
    if (rate.empty()) return std::numeric_limits<double>::infinity();
    double fastest = 0.0, largest = 0.0, deepest = 0.0, stress = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        fastest = std::max(fastest, std::abs(rate[p]));
        largest = std::max(largest, std::abs(excess_pore_pressure(particles, p)));
        deepest = std::max(deepest, particles.initial_vertical_effective_stress[p]);
        stress = std::max(stress, -particles.stress.yy[p]);
    }
    if (deepest == 0.0) deepest = stress; // soil that began without stress
    return pressure_change * std::max(largest, least_pressure * deepest) / fastest;
}

} // namespace

double resolving_step_of_histories(const Problem& problem, double time)
{
    double step = std::numeric_limits<double>::infinity();
    for_each_history(problem,
                     [&](const History& history) { step = std::min(step, resolving_step(history, time)); });
    return step;
}

double resolving_step(const Problem& problem, double time)
{
    return std::min(resolving_step(problem.base_motion), resolving_step_of_histories(problem, time));
}

double coarsest_step(const Problem& problem, double time)
{
    double highest = 0.0; // frequency [Hz]
    if (const auto* sine = std::get_if<SineMotion>(&problem.base_motion); sine && time < duration(*sine))
        highest = sine->frequency;
    for_each_history(problem, [&](const History& history) {
        if (const auto* sine = std::get_if<SineHistory>(&history.shape))
            highest = std::max(highest, sine->frequency);
    });
    return 1.0 / (least_steps_per_period * highest); // infinite without any
}

void choose_resistance(const Problem& problem, const State& state, InertiaSolve& inertia)
{
    double damping = 0.0;
    if (state.stage == Stage::relaxation)
        damping = damping_of_settling_solids;
    else if (state.whole_step > 0.0 &&
             is_left_alone(problem, state)) // less in soil that flows, which it would stop
        damping =
            damping_of_vibrations * std::min(1.0, step_of_flow(problem, state.particles) / state.whole_step);
    inertia.resistance = inertia_fraction + damping;
    inertia.kept = inertia_fraction / inertia.resistance;
}

TimeStep accurate_time_step(const Problem& problem, double time, double last_step, double wave_step,
                            const Particles& particles, const CellExtremes& extremes)
{
    const auto at_least_wave = [&](double dt, TimeStepLimiter limiter) {
        return TimeStep{std::max(dt, wave_step), limiter, ""};
    };
    TimeStep step = at_least_wave(strain_step(particles), TimeStepLimiter::strain);
    const auto limit = [&](const TimeStep& other) { step = other.dt < step.dt ? other : step; };
    if (!is_left_alone(problem, time, particles, extremes)) {
        const double reach = smoothed_cells * problem.grid.cell_size / std::sqrt(inertia_fraction);
        limit({reach / extremes.shear_speed, TimeStepLimiter::inertia, ""});
        limit(at_least_wave(step_of_shaken_flow(problem, particles), TimeStepLimiter::flow));
        limit(at_least_wave(resolving_step(problem, time), TimeStepLimiter::shaking));
        limit(at_least_wave(step_of_own_vibration(problem, particles, extremes.shear_speed),
                            TimeStepLimiter::own_vibration));
    } else {
        const double grown = step_growth * (last_step > 0.0 ? last_step : wave_step);
        limit({grown, TimeStepLimiter::growth, ""});
        limit(at_least_wave(step_of_flow(problem, particles), TimeStepLimiter::flow));
        limit(at_least_wave(pressure_step(particles), TimeStepLimiter::pressure));
        limit(at_least_wave(resolving_step_of_histories(problem, time), TimeStepLimiter::shaking));
    }
    return step;
}

} // namespace quicksand
