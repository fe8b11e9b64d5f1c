#include "io/frames/observation_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double nanosecond = 1e-9; // what times are rounded to [s]

} // namespace

ObservationClock::ObservationClock(double interval, double end_time)
    : interval_(interval > 0.0 ? std::max(interval, nanosecond) : 0.0), end_time_(end_time),
      next_(interval > 0.0 ? 0.0 : never)
{
}

double ObservationClock::interval() const
{
    return interval_ > 0.0 ? interval_ : never;
}

void ObservationClock::go_on(double time, std::optional<double> last_observed)
{
    if (interval_ <= 0.0) return;
    count_ = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(time / interval_)) - 1);
    next_ = multiple(count_);
    while (next_ < time || (last_observed && next_ <= *last_observed)) advance();
}

void ObservationClock::advance()
{
    if (next_ >= end_time_) {
        next_ = never;
        return;
    }
    ++count_;
    next_ = multiple(count_);
}

double ObservationClock::multiple(std::int64_t k) const
{
    constexpr double nanoseconds = 1e9; // in a second
    const double time = std::round(static_cast<double>(k) * interval_ * nanoseconds) / nanoseconds;
    // The end is observed too; a multiple that misses it by rounding only is the end.
    return time > end_time_ - 1e-6 * interval_ ? end_time_ : time;
}

} // namespace quicksand
