#include "solver/run/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double least_interval = 1.0 / 3.0; // of what steps are without it
constexpr double time_rounding = 1e-9;       // of the events, which are no exact multiples [s]

/// Steps of equal length to the next event, each a part of the interval but for the rounding of the events.
double parts_of_interval(double remaining, double interval, double dt)
{
    const double part = step_of_interval(interval, dt);
    const double most_rounded = 0.25; // of a step
    const double rounded = std::min(most_rounded, time_rounding / part);
    return std::max(1.0, std::ceil(remaining / part - rounded));
}

} // namespace

double common_interval(double a, double b)
{
    const double shorter = std::min(a, b), ratio = std::max(a, b) / shorter;
    if (!std::isfinite(ratio)) return shorter;
    constexpr int most_parts = 16;     // of the shorter one
    constexpr double rounding = 1e-12; // both are multiples to the end of the run
    for (int parts = 1; parts <= most_parts; ++parts)
        if (std::abs(ratio * parts - std::round(ratio * parts)) <= rounding * ratio) return shorter / parts;
    return 0.0;
}

bool divides_well(const Events& events, double dt)
{
    if (std::isinf(events.interval)) return true;
    return events.interval > 0.0 && events.interval >= least_interval * std::min(dt, events.shortest);
}

double step_of_interval(double interval, double dt)
{
    return interval / std::max(1.0, steps_over(interval + time_rounding, dt));
}

void add_interval(double interval, double shortest, Events& events)
{
    events.interval = common_interval(events.interval, interval);
    events.shortest = std::min(events.shortest, shortest);
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
        add_interval(observer->interval(), observer->shortest_interval(), events);
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
        if (divides_well(all, dt)) return all;
    }
    return events_of(observers, Hit::those_that_do_not_look, latest);
}

TimeStep divide_evenly(TimeStep stable, const Events& events, double time)
{
    const double remaining = events.next - time;
    const bool has_parts = std::isfinite(events.interval) && divides_well(events, stable.dt);
    const double steps = has_parts ? parts_of_interval(remaining, events.interval, stable.dt)
                                   : std::max(1.0, steps_over(remaining, stable.dt));
    const double even = remaining / steps;
    if (even < 0.5 * stable.dt) stable.limiter = TimeStepLimiter::output;
    stable.dt = even;
    return stable;
}

} // namespace quicksand
