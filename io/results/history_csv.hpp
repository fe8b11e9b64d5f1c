// history.csv: the sums and extremes of the whole body over time.
#pragma once

#include "io/files/csv_file.hpp"
#include "io/frames/observation_clock.hpp"
#include "io/results/run_label.hpp"
#include "io/tables/scene.hpp"
#include "solver/run/simulation.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace quicksand {

/// The crest as it was when shaking began: numbers of the particles that lay highest in the reference shape.
std::vector<std::int32_t> reference_crest(const Particles& particles);

class HistoryWriter : public Observer {
public:
    HistoryWriter(const Scene& scene, const Problem& problem, const State& state, const RunLabel& label,
                  const std::filesystem::path& path, bool resume);

    double next_time() const override { return clock_.next(); }
    double interval() const override { return clock_.interval(); }
    bool marks_restarts() const override { return false; }
    bool looks_into_steps() const override { return true; }
    void before_step(const Problem& problem, const State& state, double end) override;
    void observe(const Problem& problem, const State& state, const StepReport& report) override;
    void went_back(const FailureRecord&, const State&) override { end_time_.reset(); }

private:
    std::vector<double> measure(const Problem& problem, const State& state,
                                std::int64_t limited_domains) const;
    void write(const std::vector<double>& values);

    ObservationClock clock_;
    CsvFile file_;
    std::vector<std::int32_t> crest_;
    double start_time_ = 0.0;           // of a step that passes the next time [s]
    std::optional<double> end_time_;    // of the last step that did, where the next one may start [s]
    std::vector<double> starts_, ends_; // of all columns at these times
};

} // namespace quicksand
