#include "solver/run/observer.hpp"

#include <algorithm>

namespace quicksand {

double next_event(const std::vector<Observer*>& observers, double latest)
{
    double next = latest;
    for (const Observer* observer : observers) next = std::min(next, observer->next_time());
    return next;
}

void observe_due(const Problem& problem, const std::vector<Observer*>& observers, const State& state,
                 const StepReport& report)
{
    for (Observer* observer : observers) {
        if (observer->next_time() <= state.time) observer->observe(problem, state, report);
    }
}

} // namespace quicksand
