#include "io/reports/run_motion.hpp"

#include "io/pictures/line_plot.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/reports/motion_figures.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_manifest.hpp"
#include "io/results/run_record.hpp"
#include "io/scene/scene_file.hpp"
#include "solver/base/conventions.hpp"
#include "solver/base/failure.hpp"
#include "solver/problem/motion_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr double damping = 0.05; // of the spectra [-]

/// At its own interval; a sine at its resolving step, to the end of the run.
SampledMotion sampled(const BaseMotion& motion, double end_time)
{
    if (const auto* record = std::get_if<SampledMotion>(&motion)) return *record;
    if (std::holds_alternative<NoMotion>(motion)) return {};
    SampledMotion samples{resolving_step(motion), {}};
    const double end = std::min(end_time, duration(motion));
    for (double step = 0.0; step * samples.interval <= end; step += 1.0)
        samples.accelerations.push_back(base_acceleration(motion, step * samples.interval));
    return samples;
}

/// None where the scene is not what was run any more.
std::optional<SampledMotion> motion_of_scene(const fs::path& results)
{
    const RunRecord record = read_run_record(ResultsFolder{results}.manifest());
    std::error_code error;
    if (!fs::is_regular_file(record.scene_file, error)) return std::nullopt;
    try {
        for (const SceneReading& stage : read_scene_stages(record.scene_file, record.overrides)) {
            if (scene_hash(stage.scene.text, record.overrides) != record.scene_hash) continue;
            return sampled(stage.scene.base_motion, std::max(record.simulated_time, stage.scene.end_time));
        }
        return std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

SampledMotion motion_of_history(const fs::path& results)
{
    const fs::path file = ResultsFolder{results}.history();
    if (!fs::exists(file)) return {};
    const PictureTable table = read_picture_table(file);
    const std::vector<double>* times = table.find("time_s");
    const std::vector<double>* values = table.find("base_acceleration_m_s2");
    if (times == nullptr || values == nullptr || times->size() < 3) return {};
    // the last row need not lie on the interval
    SampledMotion motion{(*times)[1] - (*times)[0], {values->begin(), values->end() - 1}};
    return motion.interval > 0.0 ? motion : SampledMotion();
}

bool is_silent(const SampledMotion& motion)
{
    return std::all_of(motion.accelerations.begin(), motion.accelerations.end(),
                       [](double acceleration) { return acceleration == 0.0; });
}

std::vector<std::vector<std::string>> measures_of(const SampledMotion& motion)
{
    const MotionMeasures measures = measure(motion);
    return {{"measure", "value"},
            {"PGA", fmt::format("{:.3g} g at {:.4g} s", measures.peak_acceleration / standard_gravity,
                                measures.peak_time)},
            {"PGV", fmt::format("{:.3g} m/s", measures.peak_velocity)},
            {"PGD", fmt::format("{:.3g} m", measures.peak_displacement)},
            {"Arias intensity", fmt::format("{:.3g} m/s", measures.arias_intensity)},
            {"significant duration D5-95", fmt::format("{:.3g} s", measures.significant_duration)},
            {"velocity at the end", fmt::format("{:.2g} m/s", measures.residual_velocity)}};
}

} // namespace

RunMotion motion_of_run(const fs::path& results, const std::function<void(const std::string&)>& notify)
{
    RunMotion run{{}, "base motion of the scene", {}};
    if (auto motion = motion_of_scene(results)) {
        run.motion = std::move(*motion);
    } else {
        notify("the scene that was run is not there any more, or not as it was: the motion is that of "
               "history.csv");
        run.motion = motion_of_history(results);
        run.origin = "base motion at the rows of history.csv";
    }
    if (is_silent(run.motion)) run.motion.accelerations.clear();
    if (run.motion.accelerations.size() >= 2) run.measures = measures_of(run.motion);
    return run;
}

std::vector<Drawing> motion_drawings(const RunMotion& motion, const fs::path& folder)
{
    const NamedMotion named{"", motion.motion,
                            response_spectrum(motion.motion, spectral_periods(motion.motion), damping)};
    return {plot_drawing(motion_histories_plot("Motion of the base", motion.origin, {named}),
                         folder / "motion.png"),
            plot_drawing(motion_spectra_plot("Response spectra of the base", "5 % damping", {named}),
                         folder / "spectrum.png")};
}

} // namespace quicksand
