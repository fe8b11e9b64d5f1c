// The times that steps have to hit.
#include "solver/columns/soil_column.hpp"
#include "solver/run/column_observer.hpp"
#include "solver/run/events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quicksand {
namespace {

/// Waits for one time.
class Waiting final : public Observer {
public:
    Waiting(double time, bool looks_into_steps) : time_(time), looks_into_steps_(looks_into_steps) {}
    double next_time() const override { return time_; }
    double interval() const override { return time_; }
    bool looks_into_steps() const override { return looks_into_steps_; }
    void observe(const Problem&, const State&, const StepReport&) override {}

private:
    double time_; // [s]
    bool looks_into_steps_;
};

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Events, AreTheEarliestOfThoseThatAreHit)
{
    Waiting frame(0.3, false), history(0.2, true), never(infinite, false);
    const std::vector<Observer*> observers{&frame, &history, &never};
    EXPECT_EQ(events_of(observers, Hit::all, 1.0).next, 0.2);
    EXPECT_EQ(events_of(observers, Hit::all, 0.1).next, 0.1);
    EXPECT_EQ(events_of(observers, Hit::those_that_do_not_look, 1.0).next, 0.3);
    EXPECT_EQ(events_of({&never}, Hit::all, infinite).next, infinite);
}

TEST(Events, AreTheLastOfThoseThatDifferByRounding)
{
    const double end = 0.3, a_little_before = 0.3 - 1e-12, before = 0.3 - 1e-9;
    Waiting first(a_little_before, false), earlier(before, false);
    EXPECT_EQ(events_of({&first}, Hit::all, end).next, end);
    EXPECT_EQ(events_of({&first}, Hit::all, a_little_before).next, a_little_before);
    EXPECT_EQ(events_of({&earlier, &first}, Hit::all, end).next, before);
}

/// Whether steps of dt hit a history beside frames.
bool hit_history(double dt, double history_interval, TimeScheme scheme = TimeScheme::explicit_steps)
{
    Problem problem;
    problem.scheme = scheme;
    Waiting frame(0.3, false), history(history_interval, true);
    return events_to_hit(problem, {&frame, &history}, 1.0, dt).next == history_interval;
}

TEST(Events, LeaveOutHistoriesByWhichStepsWouldAlternate)
{
    EXPECT_TRUE(hit_history(0.1, 0.2)) << "parts of 0.1";
    EXPECT_TRUE(hit_history(0.3, 0.2)) << "likewise, a third of dt";
    EXPECT_TRUE(hit_history(9.0, 0.2)) << "half of the shortest";
    EXPECT_FALSE(hit_history(0.1, 0.17)) << "1/17 of 0.3 is far less than dt";
    EXPECT_FALSE(hit_history(0.01, 0.17)) << "events of two clocks come as near to each other as they like";
    EXPECT_FALSE(hit_history(0.01, 0.2, TimeScheme::implicit));
}

/// The step of at most dt from `time` on.
double step_to(const Events& events, double dt, double time = 0.0)
{
    TimeStep stable;
    stable.dt = dt;
    return divide_evenly(stable, events, time).dt;
}

TEST(Events, AreReachedInEqualSteps)
{
    EXPECT_DOUBLE_EQ(step_to({0.3, 0.1, 0.2}, 0.095), 0.05);
    EXPECT_DOUBLE_EQ(step_to({0.3, 0.1, 0.2}, 0.095, 0.2), 0.05);
    EXPECT_DOUBLE_EQ(step_to({0.3, 0.1, 0.2}, 0.5), 0.1);
    EXPECT_DOUBLE_EQ(step_to({0.3, 0.0, 0.2}, 0.16), 0.15) << "no interval";
    EXPECT_DOUBLE_EQ(step_to({0.3, infinite, infinite}, 0.11), 0.1) << "the end alone";
}

/// The longest step of at most dt over the shortest, where events are multiples of the interval rounded to
/// nanoseconds, as those of clocks are.
double most_over_least(double interval, double dt)
{
    double time = 0.0, least = infinite, most = 0.0;
    for (int k = 1; k <= 400; ++k) {
        const double event = std::round(k * interval * 1e9) * 1e-9;
        while (time < event) {
            const double step = step_to({event, interval, interval}, dt, time);
            least = std::min(least, step);
            most = std::max(most, step);
            time = step >= event - time ? event : time + step;
        }
    }
    EXPECT_LE(most, dt * (1.0 + 1e-12));
    return most / least;
}

TEST(Events, AreRoundedAndStepsDoNotAlternateByIt)
{
    for (const double end : {0.056, 0.056001, 0.056002, 0.072001, 0.123457})
        for (const double part : {0.4, 0.501, 0.9999999, 1.0, 1.000001, 2.5})
            EXPECT_LT(most_over_least(end / 4000.0, part * end / 4000.0), 1.001) << end << ", " << part;
}

TEST(Events, GiveTheSameStepsToAColumn)
{
    const SoilColumn column;
    const Problem body;
    Waiting probe(0.2, true), history(0.225, true);
    ColumnObserver both(column, body, {&probe, &history});
    const Events events = events_of({&probe, &history}, Hit::all, 1.0);
    const Events of_column = events_of({&both}, Hit::all, 1.0);
    EXPECT_EQ(of_column.next, events.next);
    EXPECT_EQ(of_column.interval, events.interval);
    EXPECT_EQ(of_column.shortest, events.shortest);
}

TEST(Events, WithoutCommonIntervalAreNotHit)
{
    const SoilColumn column;
    const Problem body;
    Waiting probe(0.2, true), history(0.37137, true);
    ColumnObserver both(column, body, {&probe, &history});
    Problem problem;
    problem.scheme = TimeScheme::explicit_steps;
    EXPECT_EQ(events_to_hit(problem, {&both}, 1.0, 0.1).next, 1.0);
    EXPECT_DOUBLE_EQ(step_to({0.2, 0.0, 0.0}, 0.08), 0.2 / 3.0) << "neither is a step of no length";
}

TEST(CommonInterval, DividesBoth)
{
    EXPECT_DOUBLE_EQ(common_interval(0.002, 0.005), 0.001);
    EXPECT_DOUBLE_EQ(common_interval(0.02, 0.01), 0.01);
    EXPECT_DOUBLE_EQ(common_interval(0.01, infinite), 0.01);
    EXPECT_EQ(common_interval(infinite, infinite), infinite);
    EXPECT_EQ(common_interval(0.01, 0.01 * std::numbers::sqrt2), 0.0);
    EXPECT_EQ(common_interval(0.01, 0.00333333), 0.0) << "thirds that move apart in a run";
    EXPECT_DOUBLE_EQ(common_interval(0.01, 0.01 / 3.0), 0.01 / 3.0);
    EXPECT_EQ(common_interval(1.0, 1e-6 * std::numbers::pi), 0.0);
    EXPECT_EQ(common_interval(0.0, 0.01), 0.0) << "what has none keeps none";
}

} // namespace
} // namespace quicksand
