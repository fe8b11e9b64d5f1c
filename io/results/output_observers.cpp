#include "io/results/output_observers.hpp"

#include "io/files/background_writer.hpp"
#include "io/frames/frame_writer.hpp"
#include "io/frames/grid_frame.hpp"
#include "io/frames/particle_frame.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/history_csv.hpp"
#include "io/results/probe_writer.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/steps_csv.hpp"

#include <utility>

namespace quicksand {

namespace {

std::unique_ptr<Observer> make_frame_writer(const Scene& scene, const State& state,
                                            const OutputSettings& settings,
                                            const std::shared_ptr<BackgroundWriter>& background)
{
    const ResultsFolder folder{settings.directory};
    const auto open = [&](const std::filesystem::path& index) {
        return settings.resume ? VtkSeries::resume(index, state.time) : VtkSeries(index);
    };
    std::vector<FrameSeries> all_series;
    all_series.push_back({open(folder.particle_series()), particle_frame});
    all_series.push_back({open(folder.grid_series()), [](const Problem& problem, const State& state_) {
                              return grid_frame(problem, nodal_fields(problem, state_.particles),
                                                state_.time);
                          }});
    return std::make_unique<FrameWriter>(std::move(all_series),
                                         ObservationClock(scene.output.frame_interval, scene.end_time),
                                         state.time, background);
}

} // namespace

std::vector<std::unique_ptr<Observer>> make_output_observers(const Scene& scene, const Problem& problem,
                                                             const State& state,
                                                             const OutputSettings& settings)
{
    const ResultsFolder folder{settings.directory};
    const RunLabel label{scene.file, settings.scene_hash};
    const SceneOutput& output = scene.output;
    std::vector<std::unique_ptr<Observer>> observers;
    const auto background = std::make_shared<BackgroundWriter>();
    if (output.frame_interval > 0.0)
        observers.push_back(make_frame_writer(scene, state, settings, background));
    if (output.probe_interval > 0.0 && !scene.probes.empty())
        observers.push_back(
            std::make_unique<ProbeWriter>(scene, problem, state, label, settings.directory, settings.resume));
    if (output.history_interval > 0.0) {
        observers.push_back(
            std::make_unique<HistoryWriter>(scene, problem, state, label, folder.history(), settings.resume));
        observers.push_back(
            std::make_unique<StepsWriter>(scene, problem, state, label, folder.steps(), settings.resume));
    }
    if (output.checkpoint_interval > 0.0)
        observers.push_back(std::make_unique<CheckpointWriter>(
            folder.checkpoint(), output.checkpoint_interval, settings.kept ? *settings.kept : state,
            settings.state_hash, background));
    return observers;
}

} // namespace quicksand
