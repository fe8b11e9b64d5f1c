#include "solver/run/observer.hpp"

#include <algorithm>

namespace quicksand {

namespace {

bool steps_are_shortened(const Problem& problem, const Observer& observer)
{
    return problem.scheme != TimeScheme::implicit || !observer.looks_into_steps();
}

} // namespace

bool is_observed(const std::vector<Observer*>& observers, const State& state)
{
    return std::any_of(observers.begin(), observers.end(),
                       [&](const Observer* observer) { return observer->next_time() <= state.time; });
}

double next_event(const Problem& problem, const std::vector<Observer*>& observers, double latest)
{
    double next = latest;
    for (const Observer* observer : observers)
        if (steps_are_shortened(problem, *observer)) next = std::min(next, observer->next_time());
    return next;
}

void show_start(const Problem& problem, const std::vector<Observer*>& observers, const State& state,
                double end)
{
    for (Observer* observer : observers)
        if (!steps_are_shortened(problem, *observer) && observer->next_time() <= end)
            observer->before_step(problem, state, end);
}

void observe_due(const Problem& problem, const std::vector<Observer*>& observers, const State& state,
                 const StepReport& report)
{
    for (Observer* observer : observers) {
        if (observer->next_time() <= state.time) observer->observe(problem, state, report);
    }
}

} // namespace quicksand
