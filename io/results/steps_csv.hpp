// steps.csv: how the run is going. Time step and its reason, wall time and what is left, conservation.
#pragma once

#include "io/files/csv_file.hpp"
#include "io/frames/observation_clock.hpp"
#include "io/results/documented_name.hpp"
#include "io/results/run_label.hpp"
#include "io/tables/scene.hpp"
#include "solver/run/simulation.hpp"

#include <chrono>
#include <filesystem>
#include <optional>

namespace quicksand {

/// All columns of steps.csv.
std::vector<DocumentedName> step_columns();

class StepsWriter : public Observer {
public:
    StepsWriter(const Scene& scene, const Problem& problem, const State& state, const RunLabel& label,
                const std::filesystem::path& path, bool resume);

    double next_time() const override { return clock_.next(); }
    double interval() const override { return clock_.interval(); }
    bool looks_into_steps() const override { return true; }
    void observe(const Problem& problem, const State& state, const StepReport& report) override;
    void after_step(const StepReport& report) override { remember(report); }

private:
    void remember(const StepReport& report);
    double wall_time() const;
    double time_left(double time) const;

    ObservationClock clock_;
    CsvFile file_;
    double start_time_;              // t at which this process began [s]
    double end_time_;                // [s]
    double earlier_wall_time_ = 0.0; // of the processes before a resume [s]
    std::chrono::steady_clock::time_point began_;
    std::optional<TimeStep> natural_step_; // the last one that was not shortened for output
    std::optional<double> initial_mass_;   // of the first row [kg/m]
};

} // namespace quicksand
