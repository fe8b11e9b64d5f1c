#include "solver/run/column_observer.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/events.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

bool looks_into(const Observer* observer)
{
    return observer->looks_into_steps();
}

} // namespace

ColumnObserver::ColumnObserver(const SoilColumn& column, const Problem& body,
                               std::vector<Observer*> observers)
    : column_(column), body_(body), observers_(std::move(observers))
{
    ENSURE(looks_into_steps() || std::none_of(observers_.begin(), observers_.end(), looks_into));
}

StepReport ColumnObserver::report_of_body(const StepReport& report) const
{
    StepReport whole = report;
    whole.limited_domains *= static_cast<std::int64_t>(column_.repeats());
    return whole;
}

double ColumnObserver::next_time() const
{
    double next = std::numeric_limits<double>::infinity();
    for (const Observer* observer : observers_) next = std::min(next, observer->next_time());
    return next;
}

double ColumnObserver::interval() const
{
    double interval = std::numeric_limits<double>::infinity();
    for (const Observer* observer : observers_) interval = common_interval(interval, observer->interval());
    return interval;
}

double ColumnObserver::shortest_interval() const
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const Observer* observer : observers_) shortest = std::min(shortest, observer->shortest_interval());
    return shortest;
}

bool ColumnObserver::marks_restarts() const
{
    const double next = next_time();
    return std::any_of(observers_.begin(), observers_.end(), [next](const Observer* observer) {
        return observer->marks_restarts() && observer->next_time() <= next;
    });
}

bool ColumnObserver::looks_into_steps() const
{
    return std::all_of(observers_.begin(), observers_.end(), looks_into);
}

void ColumnObserver::widen_once(const State& state)
{
    if (wide_.step == state.step && wide_.time == state.time && !wide_.particles.identifier.empty()) return;
    widen(column_, state, wide_);
}

void ColumnObserver::before_step(const Problem&, const State& state, double end)
{
    widen_once(state);
    show_start(body_, observers_, wide_, end);
}

void ColumnObserver::observe(const Problem&, const State& state, const StepReport& report)
{
    widen_once(state);
    observe_due(body_, observers_, wide_, report_of_body(report));
}

void ColumnObserver::after_step(const StepReport& report)
{
    for (Observer* observer : observers_) observer->after_step(report_of_body(report));
}

void ColumnObserver::went_back(const FailureRecord& record, const State& state)
{
    wide_ = {}; // its step may be taken again, and end elsewhere
    for (Observer* observer : observers_) observer->went_back(record, state);
}

void ColumnObserver::finish()
{
    for (Observer* observer : observers_) observer->finish();
}

} // namespace quicksand
