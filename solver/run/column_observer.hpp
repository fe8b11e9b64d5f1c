// Observers of a body whose single column is computed.
#pragma once

#include "solver/columns/soil_column.hpp"
#include "solver/run/observer.hpp"

#include <vector>

namespace quicksand {

/// Shows observers the whole body while the column runs.
class ColumnObserver : public Observer {
public:
    /// All outlive the observer; `body` is the problem that the column was found in. Either all observers
    /// look into steps or none does.
    ColumnObserver(const SoilColumn& column, const Problem& body, std::vector<Observer*> observers);

    double next_time() const override;
    double interval() const override;
    double shortest_interval() const override;
    bool marks_restarts() const override;
    bool looks_into_steps() const override;
    void before_step(const Problem& problem, const State& state, double end) override;
    void observe(const Problem& problem, const State& state, const StepReport& report) override;
    void after_step(const StepReport& report) override;
    void went_back(const FailureRecord& record, const State& state) override;
    void finish() override;

private:
    StepReport report_of_body(const StepReport& report) const;
    /// The state at the end of a step is that at the start of the next.
    void widen_once(const State& state);

    const SoilColumn& column_;
    const Problem& body_;
    std::vector<Observer*> observers_;
    State wide_;
};

} // namespace quicksand
