#include "solver/run/simulation.hpp"

#include "solver/motion/particle_order.hpp"
#include "solver/run/held_reactions.hpp"
#include "solver/run/soil_column.hpp"
#include "solver/run/watchdog.hpp"
#include "solver/step/stepper.hpp"
#include "solver/vibration/step_bound.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr std::int64_t steps_between_restarts = 32;

/// Equal steps to the next event: the step is shortened a little each time rather than much at the end.
TimeStep divide_evenly(TimeStep stable, double remaining)
{
    constexpr double rounding = 1e-6; // of a step: the last division is not split by rounding
    const double steps = std::max(1.0, std::ceil(remaining / stable.dt - rounding));
    if (steps == 1.0 && remaining < 0.5 * stable.dt) stable.limiter = TimeStepLimiter::output;
    stable.dt = remaining / steps;
    return stable;
}

/// Whether an observer that marks restarts waits for the state's time.
bool marks_restart(const std::vector<Observer*>& observers, const State& state)
{
    return std::any_of(observers.begin(), observers.end(), [&](const Observer* observer) {
        return observer->marks_restarts() && observer->next_time() <= state.time;
    });
}

/// The step to the next time that an observer waits for, or to the end.
TimeStep choose_step(const Problem& problem, double event, State& state)
{
    if (state.step % steps_between_bounds == 0) measure_bound(problem, state);
    return divide_evenly(bounded_time_step(problem, state), event - state.time);
}

/// One step; true where it arrives at the event.
bool take_step(const Problem& problem, double dt, double event, Stepper& stepper, State& state)
{
    const bool arrives = dt >= event - state.time;
    stepper.advance(problem, dt, state);
    wrap_particles(problem, state.particles);
    if (arrives) state.time = event; // hit exactly, without the sum's rounding
    check_particles(dt, state);
    return arrives;
}

} // namespace

bool run(const Problem& problem, double end_time, const std::vector<Observer*>& observers, State& state,
         const StopRule& stop)
{
    if (state.step == 0) hold_reactions(problem, state);
    std::unique_ptr<Stepper> stepper = make_stepper(problem);
    StepReport report{state.step, state.time, {}, 0, true};
    observe_due(problem, observers, state, report);
    Watchdog watchdog(problem, state);
    while (state.time < end_time) {
        bool arrives = false;
        try {
            const double event = next_event(observers, end_time);
            report.time_step = choose_step(problem, event, state);
            arrives = take_step(problem, report.time_step.dt, event, *stepper, state);
            report.is_restart_point = state.time >= end_time || marks_restart(observers, state) ||
                                      state.step % steps_between_restarts == 0;
            if (report.is_restart_point) watchdog.check(problem, report.time_step.dt, state);
            if (arrives) watchdog.check_growth(problem, report.time_step.dt, state); // before it is looked at
        } catch (const NumericalError& error) {
            watchdog.go_back(error, state);
            stepper = make_stepper(problem);
            for (Observer* observer : observers) observer->went_back(error.record, state);
            continue;
        }
        report.step = state.step;
        report.time = state.time;
        report.limited_domains = stepper->limited_domains();
        for (Observer* observer : observers) observer->after_step(report);
        if (report.is_restart_point) watchdog.keep(problem, state);
        if (arrives) observe_due(problem, observers, state, report);
        if (!report.is_restart_point) continue;
        stepper->restart();
        if (stop && stop()) break;
    }
    for (Observer* observer : observers) observer->finish();
    return state.time >= end_time;
}

} // namespace quicksand
