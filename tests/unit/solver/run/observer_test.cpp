// The times that steps have to hit.
#include "solver/run/events.hpp"

#include <gtest/gtest.h>

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
    EXPECT_TRUE(hit_history(0.01, 0.17)) << "17 steps are as good as even";
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

TEST(CommonInterval, DividesBoth)
{
    EXPECT_DOUBLE_EQ(common_interval(0.002, 0.005), 0.001);
    EXPECT_DOUBLE_EQ(common_interval(0.02, 0.01), 0.01);
    EXPECT_DOUBLE_EQ(common_interval(0.01, infinite), 0.01);
    EXPECT_EQ(common_interval(infinite, infinite), infinite);
    EXPECT_EQ(common_interval(0.01, 0.01 * std::numbers::sqrt2), 0.0);
    EXPECT_EQ(common_interval(0.0, 0.01), 0.0) << "what has none keeps none";
}

} // namespace
} // namespace quicksand
