// The probes of a scene, written to probes/<name>.csv at the probe interval.
#pragma once

#include "io/files/csv_file.hpp"
#include "io/frames/observation_clock.hpp"
#include "io/results/run_label.hpp"
#include "io/tables/scene.hpp"
#include "solver/measure/point_sample.hpp"
#include "solver/run/simulation.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

class ProbeWriter : public Observer {
public:
    /// Begins the files, or goes on with them at state.time when `resume`. Throws InputError for a probe
    /// without a place and for a material probe outside the soil, FileError for the files.
    ProbeWriter(const Scene& scene, const Problem& problem, const State& state, const RunLabel& label,
                const std::filesystem::path& results, bool resume);

    double next_time() const override { return clock_.next(); }
    double interval() const override { return clock_.interval(); }
    bool marks_restarts() const override { return false; }
    bool looks_into_steps() const override { return true; }
    void before_step(const Problem& problem, const State& state, double end) override;
    void observe(const Problem& problem, const State& state, const StepReport& report) override;
    void went_back(const FailureRecord&, const State&) override { end_time_.reset(); }

private:
    struct Probe {
        SceneProbe scene;
        std::int32_t identifier = -1; // of the particle a material probe rides with
        CsvFile file;
        double previous_time = PointSample::none;
        std::vector<Vector2> previous_velocities; // one a point, at previous_time [m/s]
    };

    Probe open_probe(const SceneProbe& scene_probe, const Problem& problem, const State& state,
                     const RunLabel& label, const std::filesystem::path& results, bool resume) const;
    /// Of all probes, point by point.
    std::vector<std::vector<PointSample>> sample(const Problem& problem, const State& state) const;
    std::vector<PointSample> sample(const Probe& probe, const Problem& problem, const State& state,
                                    const NodalFields& fields) const;
    void write(Probe& probe, double time, std::vector<PointSample> samples) const;

    std::vector<const Quantity*> quantities_; // that are written; a dry scene has none of the water
    std::vector<Vector2> fixed_points_;       // of all fixed probes and profiles [m]
    ObservationClock clock_;
    std::vector<Probe> probes_;
    double start_time_ = 0.0;        // of a step that passes the next time [s]
    std::optional<double> end_time_; // of the last step that did, where the next one may start [s]
    std::vector<std::vector<PointSample>> starts_, ends_; // of all probes at these times
};

} // namespace quicksand
