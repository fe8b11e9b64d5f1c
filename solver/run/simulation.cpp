#include "solver/run/simulation.hpp"

#include "solver/columns/soil_column.hpp"
#include "solver/free_field/free_field_steps.hpp"
#include "solver/free_field/wave_steps.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/motion/wrapping.hpp"
#include "solver/run/events.hpp"
#include "solver/run/held_reactions.hpp"
#include "solver/run/watchdog.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step/stepper.hpp"
#include "solver/vibration/step_bound.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

constexpr std::int64_t steps_between_restarts = 32;

/// Whether an observer that marks restarts waits for the state's time.
bool marks_restart(const std::vector<Observer*>& observers, const State& state)
{
    return std::any_of(observers.begin(), observers.end(), [&](const Observer* observer) {
        return observer->marks_restarts() && observer->next_time() <= state.time;
    });
}

/// A step, and the time that it must not pass [s].
struct StepToEvent {
    TimeStep step;
    double event;
};

/// The step to the next time that it has to hit.
template <class EventsFor>
StepToEvent choose_step(const Problem& problem, EventsFor&& events_for, State& state)
{
    TimeStep step = shortest_time_step(problem, state);
    step.scheme = problem.scheme;
    note_whole_step(step.dt, state);
    const Events events = events_for(problem, step.dt);
    return {divide_evenly(step, events, state.time), events.next};
}

/// The same in a run of implicit steps, where waves limit it in place of `replaced`.
template <class EventsFor>
StepToEvent choose_wave_step(const Problem& wave_form, double replaced, EventsFor&& events_for, State& state)
{
    StepToEvent chosen = choose_step(wave_form, events_for, state);
    chosen.step.dt = std::min(chosen.step.dt, step_after(state.last_step, state.whole_step));
    chosen.step.replaced = replaced;
    return chosen;
}

/// Forces act from the middle of the last step to that of the next: after long steps of consolidation a stage
/// of short ones begins as if its own had gone before, or what is out of balance at its start would act for
/// hours.
void shorten_last_step(const Problem& problem, State& state)
{
    const double last_step = state.last_step;
    state.last_step = 0.0;
    const TimeStep first = shortest_time_step(problem, state);
    state.last_step = first.limiter == TimeStepLimiter::growth ? last_step : std::min(last_step, first.dt);
    for (FreeFieldState& side : state.free_fields)
        side.column.last_step = std::min(side.column.last_step, state.last_step);
}

/// The steps of a problem and of its other forms: with steps that waves limit, which may cost less than
/// implicit ones, and with explicit steps, which the watchdog may ask for.
class Steps {
public:
    explicit Steps(const Problem& problem)
        : problem_(problem), explicit_form_(with_scheme(problem, TimeScheme::explicit_steps)), form_(&problem)
    {
        if (problem.scheme == TimeScheme::implicit)
            wave_form_ = with_scheme(problem, scheme_of_waves(problem));
        make_steppers();
    }

    /// From nothing, as a run that begins with the state would.
    void begin_anew()
    {
        is_restart_ = true;
        make_steppers();
    }

    /// Measure the bound of the explicit steps that are to follow.
    void measure(State& state) const
    {
        if (state.step < state.explicit_end) measure_bounds(explicit_form_, state);
    }

    /// Choose the kind of the step that is due, of the cheapest if the watchdog asks for none: at restart
    /// points alone, so that a run that goes on from there chooses alike.
    void choose_kind(State& state)
    {
        const bool is_explicit = state.step < state.explicit_end;
        if (state.step % steps_between_bounds == 0 || state.step == state.explicit_end)
            measure_bounds(is_explicit ? explicit_form_ : problem_, state);
        if (is_explicit || !(std::exchange(is_restart_, false) || form_ == &explicit_form_)) return;
        if (wave_form_) replaced_ = step_replaced_by_waves(problem_, *wave_form_, state);
        change_over(replaced_ ? *wave_form_ : problem_);
    }

    /// The problem with the scheme of the steps that are taken.
    const Problem& form() const { return *form_; }

    /// The step of that kind, or the explicit one that the watchdog asks for.
    /// `events_for` gives what steps of a form of at most a length [s] have to hit.
    template <class EventsFor>
    StepToEvent choose(EventsFor&& events_for, State& state)
    {
        if (state.step < state.explicit_end) return choose_explicit(events_for, state);
        return replaced_ ? choose_wave_step(*wave_form_, replaced_->dt, events_for, state)
                         : choose_step(problem_, events_for, state);
    }

    /// One step, to the event at most.
    void take(double dt, double event, State& state)
    {
        const bool arrives = dt >= event - state.time;
        free_fields_->advance(*form_, dt, state);
        stepper_->advance(*form_, dt, state);
        wrap_particles(*form_, state.particles);
        if (arrives) state.time = event; // hit exactly, without the sum's rounding
        for (FreeFieldState& field : state.free_fields) field.column.time = state.time;
        check_particles(dt, state);
    }

    void restart()
    {
        is_restart_ = true;
        stepper_->restart();
        free_fields_->restart();
    }

    std::int64_t limited_domains() const { return stepper_->limited_domains(); }

private:
    template <class EventsFor>
    StepToEvent choose_explicit(EventsFor&& events_for, State& state)
    {
        StepToEvent chosen = choose_step(explicit_form_, events_for, state);
        TimeStep& step = chosen.step;
        if (step.limiter == TimeStepLimiter::wave) step.limiter = TimeStepLimiter::sound;
        // forces act from the middle of the last step on: over a long interval pressures have to be implicit
        constexpr double most_shrinking = 0.5;
        const double least = most_shrinking * state.last_step * part_after_halvings(state);
        change_over(step.dt >= least ? explicit_form_ : problem_);
        step.scheme = form_->scheme;
        if (step.dt >= least) return chosen;
        chosen.event = events_for(*form_, least).next;
        step.dt = std::min(least, chosen.event - state.time);
        return chosen;
    }

    void change_over(const Problem& form)
    {
        if (form_ == &form) return;
        form_ = &form;
        make_steppers();
    }

    void make_steppers()
    {
        stepper_ = make_stepper(*form_);
        free_fields_.emplace(*form_);
    }

    const Problem& problem_;
    Problem explicit_form_;
    std::optional<Problem> wave_form_; // in a run of implicit steps
    const Problem* form_;              // of the steps that are taken
    bool is_restart_ = true;           // whether the kind of the steps is to be chosen
    std::optional<TimeStep> replaced_; // the implicit step in the place of which waves limit the steps
    std::unique_ptr<Stepper> stepper_;
    std::optional<FreeFieldSteps> free_fields_;
};

} // namespace

bool run(const Problem& problem, double end_time, const std::vector<Observer*>& observers, State& state,
         const StopRule& stop)
{
    const bool goes_on = state.last_step > 0.0; // from another stage, with what was held then
    if (state.step == 0 && !goes_on) hold_reactions(problem, state);
    if (state.step == 0 && goes_on) shorten_last_step(problem, state);
    Steps steps(problem);
    StepReport report{state.step, state.time, {}, 0, true};
    observe_due(problem, observers, state, report);
    Watchdog watchdog(problem, state);
    while (state.time < end_time) {
        try {
            steps.choose_kind(state);
            const auto events_for = [&](const Problem& form, double dt) {
                return events_to_hit(form, observers, end_time, dt);
            };
            const auto [step, event] = steps.choose(events_for, state);
            report.time_step = step;
            show_start(problem, observers, state, std::min(event, state.time + report.time_step.dt));
            steps.take(report.time_step.dt, event, state);
            report.is_restart_point = state.time >= end_time || marks_restart(observers, state) ||
                                      state.step % steps_between_restarts == 0;
            if (report.is_restart_point) watchdog.check(steps.form(), report.time_step.dt, state);
            if (is_observed(observers, state))
                watchdog.check_growth(steps.form(), report.time_step.dt, state);
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
