// Writes files from a copy of the state while the run goes on.
#pragma once

#include "solver/problem/state.hpp"

#include <functional>
#include <future>

namespace quicksand {

/// Jobs are done one after the other in the order they were given, so that a checkpoint never stands for more
/// than the frames before it. There is one copy of the state, and hence one job under way at most. Going out
/// of scope waits for it and drops its failure: another one is then on its way.
class BackgroundWriter {
public:
    using Job = std::function<void(const State&)>;

    /// Copy the state and hand the copy to `job` on another thread. Waits for the job before, and throws its
    /// failure.
    void write(const State& state, Job job);

    /// Throw the failure of a job that has ended with one; does not wait.
    void report_failure();

    /// Wait for the job under way and throw its failure.
    void finish();

    /// Wait for the job under way and keep its failure for who asks next.
    void wait() const;

private:
    State copy_;
    std::future<void> under_way_; // after the copy: its end is waited for before the copy goes
};

} // namespace quicksand
