#include "solver/run/observer.hpp"

#include <algorithm>

namespace quicksand {

bool is_observed(const std::vector<Observer*>& observers, const State& state)
{
    return std::any_of(observers.begin(), observers.end(),
                       [&](const Observer* observer) { return observer->next_time() <= state.time; });
}

void show_start(const Problem& problem, const std::vector<Observer*>& observers, const State& state,
                double end)
{
    for (Observer* observer : observers)
        if (observer->looks_into_steps() && observer->next_time() < end)
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
