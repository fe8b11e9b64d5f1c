// The times at which a writer looks at the run: the multiples of an interval, and the end.
//
// Times are rounded to whole nanoseconds. So 60 x 0.005 s and 3 x 0.1 s are the same number, and the run
// never takes a step of 1e-17 s between two series.
#pragma once

#include <cstdint>
#include <optional>

namespace quicksand {

class ObservationClock {
public:
    /// An interval of zero never strikes, one below a nanosecond every nanosecond [s].
    ObservationClock(double interval, double end_time);

    /// Go to the first time at or after `time`, and after `last_observed` if there is one [s].
    void go_on(double time, std::optional<double> last_observed);

    /// Infinite if it never strikes [s].
    double interval() const;

    /// The next time to observe, infinite when there is none [s].
    double next() const { return next_; }
    void advance();

    /// Call visit(time, weight) for all times that are due at the end of a step, and go on: `weight` is the
    /// part of the step before the time, 1 at its end.
    template <class Visit>
    void strike(double start, double end, Visit&& visit)
    {
        for (; next_ <= end; advance()) visit(next_, next_ < end ? (next_ - start) / (end - start) : 1.0);
    }

private:
    double multiple(std::int64_t k) const;

    double interval_;
    double end_time_;
    std::int64_t count_ = 0; // next_ is this multiple of the interval, or the end
    double next_;
};

} // namespace quicksand
