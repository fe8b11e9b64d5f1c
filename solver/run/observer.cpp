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
    std::vector<double> times{latest};
    for (const Observer* observer : observers)
        if (steps_are_shortened(problem, *observer)) times.push_back(observer->next_time());
    const double next = *std::min_element(times.begin(), times.end());
    // those that differ by rounding are one: a step from one to the other would be of no length
    constexpr double rounding = 1e-10; // of the time
    double event = next;
    for (const double time : times)
        if (time <= next * (1.0 + rounding)) event = std::max(event, time);
    return event;
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
