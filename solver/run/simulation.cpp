#include "solver/run/simulation.hpp"

#include "solver/free_field/free_field_steps.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/motion/wrapping.hpp"
#include "solver/run/held_reactions.hpp"
#include "solver/run/soil_column.hpp"
#include "solver/run/watchdog.hpp"
#include "solver/step/stepper.hpp"
#include "solver/vibration/step_bound.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace quicksand {

namespace {

constexpr std::int64_t steps_between_restarts = 32;

/// Equal steps to the next event: the step is shortened a little each time rather than much at the end.
TimeStep divide_evenly(TimeStep stable, double remaining)
{
    const double steps = std::max(1.0, steps_over(remaining, stable.dt));
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
    if (state.step % steps_between_bounds == 0 || state.step == state.explicit_end)
        measure_bounds(problem, state);
    const TimeStep step = shortest_time_step(problem, state);
    state.whole_step = step.dt;
    return divide_evenly(step, event - state.time);
}

/// The steps of a problem and of its form with explicit steps, which the watchdog may ask for.
class Steps {
public:
    explicit Steps(const Problem& problem) : problem_(problem), explicit_form_(problem)
    {
        explicit_form_.scheme = TimeScheme::explicit_steps;
        for (FreeField& field : explicit_form_.free_fields) field.column.scheme = TimeScheme::explicit_steps;
        begin_anew();
    }

    /// From nothing, as a run that begins with the state would.
    void begin_anew()
    {
        stepper_ = make_stepper(form());
        free_fields_.emplace(form());
    }

    /// Measure the bound of the explicit steps that are to follow.
    void measure(State& state) const
    {
        if (state.step < state.explicit_end) measure_bounds(explicit_form_, state);
    }

    /// Choose the step that is due, and its kind.
    TimeStep choose(double event, State& state)
    {
        if (state.step >= state.explicit_end) {
            change_over(false);
            return choose_step(problem_, event, state);
        }
        TimeStep step = choose_step(explicit_form_, event, state);
        if (step.limiter == TimeStepLimiter::wave) step.limiter = TimeStepLimiter::sound;
        // forces act from the middle of the last step on: over a long interval pressures have to be implicit
        constexpr double most_shrinking = 0.5;
        const double least = most_shrinking * state.last_step;
        change_over(step.dt >= least);
        if (step.dt < least) step.dt = std::min(least, event - state.time);
        return step;
    }

    /// One step, to the event at most.
    void take(double dt, double event, State& state)
    {
        const bool arrives = dt >= event - state.time;
        free_fields_->advance(form(), dt, state);
        stepper_->advance(form(), dt, state);
        wrap_particles(form(), state.particles);
        if (arrives) state.time = event; // hit exactly, without the sum's rounding
        for (FreeFieldState& field : state.free_fields) field.column.time = state.time;
        check_particles(dt, state);
    }

    void restart()
    {
        stepper_->restart();
        free_fields_->restart();
    }

    std::int64_t limited_domains() const { return stepper_->limited_domains(); }

private:
    const Problem& form() const { return are_explicit_ ? explicit_form_ : problem_; }

    void change_over(bool to_explicit)
    {
        if (are_explicit_ == to_explicit) return;
        are_explicit_ = to_explicit;
        begin_anew();
    }

    const Problem& problem_;
    Problem explicit_form_;
    bool are_explicit_ = false;
    std::unique_ptr<Stepper> stepper_;
    std::optional<FreeFieldSteps> free_fields_;
};

} // namespace

bool run(const Problem& problem, double end_time, const std::vector<Observer*>& observers, State& state,
         const StopRule& stop)
{
    const bool goes_on = state.last_step > 0.0; // from another stage, with what was held then
    if (state.step == 0 && !goes_on) hold_reactions(problem, state);
    Steps steps(problem);
    StepReport report{state.step, state.time, {}, 0, true};
    observe_due(problem, observers, state, report);
    Watchdog watchdog(problem, state);
    while (state.time < end_time) {
        try {
            const double event = next_event(problem, observers, end_time);
            report.time_step = steps.choose(event, state);
            show_start(problem, observers, state, std::min(event, state.time + report.time_step.dt));
            steps.take(report.time_step.dt, event, state);
            report.is_restart_point = state.time >= end_time || marks_restart(observers, state) ||
                                      state.step % steps_between_restarts == 0;
            if (report.is_restart_point) watchdog.check(problem, report.time_step.dt, state);
            if (is_observed(observers, state)) watchdog.check_growth(problem, report.time_step.dt, state);
        } catch (const NumericalError& error) {
            watchdog.go_back(error, state);
            steps.begin_anew();
            steps.measure(state);
            for (Observer* observer : observers) observer->went_back(error.record, state);
            continue;
        }
        report.step = state.step;
        report.time = state.time;
        report.limited_domains = steps.limited_domains();
        if (report.is_restart_point) watchdog.keep(problem, state);
        observe_due(problem, observers, state, report); // a checkpoint of the step comes after its rows
        for (Observer* observer : observers) observer->after_step(report);
        if (!report.is_restart_point) continue;
        steps.restart();
        if (stop && stop()) break;
    }
    for (Observer* observer : observers) observer->finish();
    return state.time >= end_time;
}

} // namespace quicksand
