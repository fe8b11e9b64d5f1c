// Observers of a run.
#pragma once

#include "solver/base/failure.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace quicksand {

/// Data of the last step for observers.
struct StepReport {
    std::int64_t step = 0;            // steps taken in the stage [-]
    double time = 0.0;                // t at the end of the step [s]
    TimeStep time_step;               // and its limiting reason
    std::int64_t limited_domains = 0; // particle domains scaled down in the step, see domain_reach [-]
    bool is_restart_point = false;    // a run resumed from here goes on with the same bits
};

/// Looks at the run without changing it. `observe` is called when the time `next_time` is hit exactly (the
/// loop shortens dt for it), also at the start of the stage; `after_step` after every step, when all that is
/// due has been observed. Steps are not always shortened for observers that look into them, see
/// events_to_hit.
class Observer {
public:
    virtual ~Observer() = default;
    /// Next time to observe [s], infinite when there is none.
    virtual double next_time() const = 0;
    /// The times it waits for are multiples of this, but for the last; infinite when there are none [s].
    virtual double interval() const { return std::numeric_limits<double>::infinity(); }
    /// The shortest time from one of them to the next, unless two of its own fall between: of several clocks,
    /// whose interval is less, that of the fastest [s].
    virtual double shortest_interval() const { return interval(); }
    /// Whether the run may be continued from the times it waits for. Those of histories lie close: setting up
    /// anew there what serves many steps would cost more than the steps.
    virtual bool marks_restarts() const { return true; }
    /// Whether values at times within a step are found between those at its two ends.
    virtual bool looks_into_steps() const { return false; }
    /// A step to `end` begins that may pass next_time(), with the state at its start. Only where the observer
    /// looks into steps and the step is not shortened for it.
    virtual void before_step(const Problem&, const State&, double /*end*/) {}
    /// The state stands at next_time(), or is the first beyond it if the observer looks into steps; the
    /// observer moves its next_time() on, beyond the state's time.
    virtual void observe(const Problem& problem, const State& state, const StepReport& report) = 0;
    virtual void after_step(const StepReport&) {}
    /// The run failed and goes on from `state`, earlier, with the remedy of the record.
    virtual void went_back(const FailureRecord&, const State&) {}
    /// The run has come to its end or was stopped: wait for what is still under way, and throw its failure.
    virtual void finish() {}
};

/// Asked between two steps from which a run can go on with the same bits: true stops it there.
using StopRule = std::function<bool()>;

/// Whether an observer waits for the state's time or an earlier one.
bool is_observed(const std::vector<Observer*>& observers, const State& state);

/// Show the state at the start of a step to `end` to the observers whose time lies within it and that look
/// into steps.
void show_start(const Problem& problem, const std::vector<Observer*>& observers, const State& state,
                double end);

/// Show the state to the observers that wait for its time.
void observe_due(const Problem& problem, const std::vector<Observer*>& observers, const State& state,
                 const StepReport& report);

} // namespace quicksand
