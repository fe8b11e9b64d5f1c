#include "solver/run/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double least_interval = 1.0 / 3.0; // of what steps are without it
constexpr double many_steps = 16.0;          // in an interval: parts of it differ by a 16th at most

/// Whether parts of the interval are steps that do not cost much more than those of dt to single events.
bool divides_well(const Events& events, double dt)
{
    return std::isinf(events.interval) || events.interval >= least_interval * std::min(dt, events.shortest);
}

} // namespace

double common_interval(double a, double b)
{
    const double shorter = std::min(a, b), ratio = std::max(a, b) / shorter;
    if (!std::isfinite(ratio)) return shorter;
    constexpr int most_parts = 16; // of the shorter one
    constexpr double rounding = 1e-6;
    for (int parts = 1; parts <= most_parts; ++parts)
        if (std::abs(ratio * parts - std::round(ratio * parts)) <= rounding * ratio) return shorter / parts;
    return 0.0;
}

Events events_of(const std::vector<Observer*>& observers, Hit hit, double latest)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Events events{latest, infinite, infinite};
    const auto is_hit = [hit](const Observer* observer) {
        return hit == Hit::all || !observer->looks_into_steps();
    };
    for (const Observer* observer : observers) {
        if (!is_hit(observer)) continue;
        events.next = std::min(events.next, observer->next_time());
        events.interval = common_interval(events.interval, observer->interval());
        events.shortest = std::min(events.shortest, observer->interval());
    }
    // those that differ by rounding are one: a step from one to the other would be of no length
    constexpr double rounding = 1e-10; // of the time
    const double next = events.next;
    const auto join = [&](double time) {
        if (time <= next * (1.0 + rounding)) events.next = std::max(events.next, time);
    };
    join(latest);
    for (const Observer* observer : observers)
        if (is_hit(observer)) join(observer->next_time());
    return events;
}

Events events_to_hit(const Problem& problem, const std::vector<Observer*>& observers, double latest,
                     double dt)
{
    if (problem.scheme != TimeScheme::implicit) {
        const Events all = events_of(observers, Hit::all, latest);
        if (divides_well(all, dt) || all.shortest >= many_steps * dt) return all;
    }
    return events_of(observers, Hit::those_that_do_not_look, latest);
}

TimeStep divide_evenly(TimeStep stable, const Events& events, double time)
{
    const double remaining = events.next - time;
    double longest = stable.dt;
    if (std::isfinite(events.interval) && divides_well(events, stable.dt))
        longest = events.interval / std::max(1.0, steps_over(events.interval, stable.dt));
    const double even = remaining / std::max(1.0, steps_over(remaining, longest));
    if (even < 0.5 * stable.dt) stable.limiter = TimeStepLimiter::output;
    stable.dt = even;
    return stable;
}

} // namespace quicksand
