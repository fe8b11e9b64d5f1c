// The complete state of a run in one HDF5 file, from which it resumes to the same bits.
#pragma once

#include "io/files/background_writer.hpp"
#include "solver/problem/state.hpp"
#include "solver/run/simulation.hpp"

#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

namespace quicksand {

/// Write the state to `path` by way of a temporary file, on the disk before it gets its name: an earlier
/// checkpoint stays whole until the new one is. Throws FileError.
void write_checkpoint(const std::filesystem::path& path, const State& state, const std::string& state_hash);

/// Read a state written for the same scene. Throws InputError for a missing file or another scene's,
/// FileError for a damaged one.
State read_checkpoint(const std::filesystem::path& path, const std::string& state_hash);

/// Writes a checkpoint at the first restart point after `interval` of wall time has passed, in the
/// background. It shortens no time step, so that a run takes the same steps with and without it.
class CheckpointWriter : public Observer {
public:
    /// `interval` in seconds of wall time; `state` is the run's and outlives the writer.
    CheckpointWriter(std::filesystem::path path, double interval, const State& state, std::string state_hash,
                     std::shared_ptr<BackgroundWriter> background);

    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override;
    void finish() override { background_->finish(); }

private:
    using Clock = std::chrono::steady_clock;
    std::filesystem::path path_;
    std::chrono::duration<double> interval_;
    const State& state_;
    std::string state_hash_;
    std::shared_ptr<BackgroundWriter> background_;
    Clock::time_point last_;
};

} // namespace quicksand
