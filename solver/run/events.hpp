// The times that steps have to hit, and steps that do so without alternating.
#pragma once

#include "solver/run/observer.hpp"
#include "solver/step_length/time_step.hpp"

#include <vector>

namespace quicksand {

/// The times that steps have to hit.
struct Events {
    double next;     // the earliest [s]
    double interval; // of which all are multiples [s], infinite for none; 0: see common_interval
    double shortest; // of the intervals of single observers [s], infinite for none
};

/// Let the events be those of one more clock, too, of that interval [s], infinite for none.
void add_interval(double interval, double shortest, Events& events);

/// Of which observers: all, or those alone that do not look into steps.
enum class Hit { all, those_that_do_not_look };

/// The earliest time of the observers, `latest` when there is no earlier one; the last of several that differ
/// by rounding alone.
Events events_of(const std::vector<Observer*>& observers, Hit hit, double latest);

/// The events that steps of at most dt [s] by the scheme of the problem hit. Implicit steps are longer than
/// histories are dense. Others hit all whose interval can be parted into steps: leapfrog with steps of 1, 1,
/// 1/2 and 1/2 drives motion by itself (parametric resonance).
Events events_to_hit(const Problem& problem, const std::vector<Observer*>& observers, double latest,
                     double dt);

/// Equal steps to the next event, of at most that length: the step is shortened a little each time rather
/// than much at the end. Where it can be, all are parts of the interval of the events, and differ only by
/// what the events are rounded by, a nanosecond.
TimeStep divide_evenly(TimeStep stable, const Events& events, double time);

/// Whether parts of the interval of the events are steps that do not cost much more than those of at most
/// dt [s] to single events.
bool divides_well(const Events& events, double dt);

/// The longest part of the interval [s] that is at most dt [s].
double step_of_interval(double interval, double dt);

/// The longest interval of which both are multiples [s], either infinite for none; 0 if it is less than a
/// 16th of the shorter one.
double common_interval(double a, double b);

} // namespace quicksand
