// How far a run is: one line that rewrites itself on a terminal, plain lines now and then elsewhere.
#pragma once

#include "app/run/journal.hpp"
#include "solver/run/simulation.hpp"

#include <chrono>
#include <cstddef>
#include <limits>
#include <string>

namespace quicksand {

class ProgressLine : public Observer {
public:
    /// From `start_time` to `end_time` [s].
    ProgressLine(double start_time, double end_time, std::size_t particles, Journal& journal);

    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override;
    void went_back(const FailureRecord& record, const State& state) override;

    /// Of the settling before the shaking.
    void show_relaxation(const SettlingProgress& settling, double tolerance);

    /// Make room for other lines.
    void clear();

    /// Steps seen, and wall time since the beginning [s].
    std::int64_t steps() const { return steps_; }
    double elapsed() const;

private:
    void show(const std::string& line, int tenth);

    double start_time_, end_time_;
    double particles_;
    Journal& journal_;
    bool terminal_;
    bool line_open_ = false;
    std::int64_t steps_ = 0;
    int last_tenth_ = 0;
    std::chrono::steady_clock::time_point began_, last_line_, last_plain_;
    std::string last_limit_; // of the last step that was not shortened for output
};

/// "out-of-balance force 0.0073 of the weight, 7,300 times the tolerance, largest at (4.5, 1) m".
std::string unbalanced_text(const UnbalancedForces& unbalanced, double tolerance);

} // namespace quicksand
