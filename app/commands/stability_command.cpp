#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/scene_setup.hpp"
#include "app/stages/run_origin.hpp"
#include "app/stages/stability_search.hpp"
#include "io/results/run_record.hpp"
#include "io/results/stage_table.hpp"
#include "io/scene/stage_beginning.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

/// A scene as read, and the results whose end is searched, none for the scene as drawn.
struct Subject {
    SceneReading reading;
    std::optional<std::filesystem::path> results;
};

/// Of a results folder the scene of its run, or of its stage.
Subject find_subject(const StabilityChoice& choice, Journal& journal)
{
    const std::filesystem::path folder = with_end(choice.scene.scene);
    if (!std::filesystem::exists(ResultsFolder{folder}.manifest()))
        return {std::move(read_stages(choice.scene, journal).front()), std::nullopt};
    const RunRecord record = read_run_record(ResultsFolder{folder}.manifest());
    SceneChoice scene = choice.scene;
    scene.scene = record.scene_file;
    scene.overrides = record.overrides;
    scene.overrides.insert(scene.overrides.end(), choice.scene.overrides.begin(),
                           choice.scene.overrides.end());
    std::vector<SceneReading> stages = read_stages(scene, journal);
    const auto is_stage = [&](const SceneReading& reading) {
        return reading.scene.stage && reading.scene.stage->name == folder.filename();
    };
    const auto found = std::find_if(stages.begin(), stages.end(), is_stage);
    SceneReading& reading = found == stages.end() ? stages.front() : *found;
    begin_later(record.simulated_time, reading.scene);
    return {std::move(reading), folder};
}

} // namespace

ExitCode assess_stability(const StabilityChoice& choice)
{
    Journal journal;
    Subject subject = find_subject(choice, journal);
    if (subject.results) part_as_in(*subject.results, subject.reading);
    SceneSetup setup = set_up_reading(choice.scene, std::move(subject.reading), journal);
    AssembledCase& assembled = setup.assembled;
    require_strength(assembled);
    if (!subject.results) require_still_water(assembled);
    const std::filesystem::path usual = subject.results
                                            ? *subject.results / "stability"
                                            : default_results(assembled.scene.file) += "-stability";
    const ResultsFolder folder = prepare_report_folder(choice.directory.empty() ? usual : choice.directory,
                                                       stability_report, assembled.scene);
    journal.keep(folder.directory / stability_report);
    if (subject.results) {
        assembled.state = end_as_state(*subject.results, setup);
    } else {
        begin_shaking(assembled.problem, assembled.state);
    }
    weaken_liquefied({choice.residual_strength, choice.liquefied_ru}, assembled, assembled.state, journal);
    StrengthReductionControls controls;
    controls.tolerance = choice.tolerance;
    controls.seismic_coefficient = choice.seismic_coefficient;
    const SafetyFactor safety = search_stability(assembled, controls, assembled.state, folder, journal);
    if (!subject.results) require_standing(safety);
    return ExitCode::good;
}

} // namespace quicksand
