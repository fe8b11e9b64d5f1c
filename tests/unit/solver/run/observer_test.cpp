// The times that steps have to hit.
#include "solver/run/observer.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quicksand {
namespace {

/// Waits for one time.
class Waiting final : public Observer {
public:
    Waiting(double time, bool looks_into_steps) : time_(time), looks_into_steps_(looks_into_steps) {}
    double next_time() const override { return time_; }
    bool looks_into_steps() const override { return looks_into_steps_; }
    void observe(const Problem&, const State&, const StepReport&) override {}

private:
    double time_; // [s]
    bool looks_into_steps_;
};

TEST(NextEvent, IsTheEarliestOfThoseThatStepsAreShortenedFor)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Problem problem;
    Waiting frame(0.3, false), history(0.2, true), never(infinite, false);
    const std::vector<Observer*> observers{&frame, &history, &never};
    EXPECT_EQ(next_event(problem, observers, 1.0), 0.2);
    EXPECT_EQ(next_event(problem, observers, 0.1), 0.1);
    problem.scheme = TimeScheme::implicit;
    EXPECT_EQ(next_event(problem, observers, 1.0), 0.3);
    EXPECT_EQ(next_event(problem, {&never}, infinite), infinite);
}

TEST(NextEvent, IsTheLastOfThoseThatDifferByRounding)
{
    const Problem problem;
    const double end = 0.3, a_little_before = 0.3 - 1e-12, before = 0.3 - 1e-9;
    Waiting first(a_little_before, false), earlier(before, false);
    EXPECT_EQ(next_event(problem, {&first}, end), end);
    EXPECT_EQ(next_event(problem, {&first}, a_little_before), a_little_before);
    EXPECT_EQ(next_event(problem, {&earlier, &first}, end), before);
}

} // namespace
} // namespace quicksand
