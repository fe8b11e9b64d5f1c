#include "app/commands/commands.hpp"
#include "app/run/flow_text.hpp"
#include "app/run/journal.hpp"
#include "app/run/plan.hpp"
#include "app/run/scene_setup.hpp"
#include "app/run/trial.hpp"
#include "io/assembly/case_checks.hpp"
#include "io/results/output_observers.hpp"
#include "io/results/results_folder.hpp"
#include "io/scene/stage_changes.hpp"
#include "io/tables/stage_keys.hpp"
#include "solver/free_field/wave_steps.hpp"
#include "solver/run/staged_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

constexpr const char* plan_file = "check.txt";

/// fields.pvd and grid.pvd with one frame of the state before any settling.
void write_initial_frame(const AssembledCase& assembled, const ResultsFolder& folder)
{
    Scene scene = assembled.scene;
    scene.output.probe_interval = scene.output.history_interval = scene.output.checkpoint_interval = 0.0;
    State state = assembled.state;
    begin_shaking(assembled.problem, state);
    for (const auto& writer :
         make_output_observers(scene, assembled.problem, state, {folder.directory, "", "", false})) {
        writer->observe(assembled.problem, state, {0, 0.0, {}, 0});
        writer->finish();
    }
}

void say_stage(const SceneReading& stage, std::size_t number, std::size_t count, Journal& journal)
{
    if (!stage.scene.stage) return;
    journal.say(fmt::format("{}Stage {} of {}: {} ({})", number > 1 ? "\n" : "", number, count,
                            stage.scene.stage->name, word_of_kind(stage.scene.stage->kind)));
}

/// Whether sand may begin the stage liquefied: no one knows before the run how its pressures limit the steps.
bool drains_sand(const AssembledCase& assembled)
{
    const auto& stage = assembled.scene.stage;
    const std::vector<Material>& materials = assembled.problem.materials;
    return stage && stage->kind == StageKind::consolidate &&
           std::any_of(materials.begin(), materials.end(), [](const Material& material) {
               return material.saturated && !memory_of(material.law).empty();
           });
}

/// Of a stage that is a run in time, and starts from a state called `start`.
void say_run(const SceneSetup& setup, const std::string& start, const ResultsFolder& folder, Journal& journal)
{
    const AssembledCase& assembled = setup.assembled;
    if (const std::string shaking = describe_motion(assembled); !shaking.empty()) journal.say(shaking);
    const StagedRun run(assembled.problem, assembled.state, run_controls(assembled.scene));
    const TimeStep step = first_time_step(run.problem(), run.state());
    journal.say(describe_time_step(assembled, step));
    journal.say(describe_cost(forecast_run(assembled, run, step, folder.directory)));
    if (drains_sand(assembled))
        journal.say(
            "  after liquefaction more steps: the pressures that the shaking leaves are not known yet; 5 "
            "and 60 times as many were seen");
    journal.say(describe_left_out(assembled.scene, run, start));
}

/// Of a stage that settles, from where the trial of the one before has ended; `reached` becomes the end of
/// its own.
void say_settling(const SceneSetup& setup, std::optional<State>& reached, Journal& journal)
{
    const AssembledCase& assembled = setup.assembled;
    StagedRun run(assembled.problem, assembled.state, run_controls(assembled.scene));
    StageStart start;
    start.settles = true;
    if (reached) run.go_on_from(std::move(*reached), start);
    journal.say(describe_settling_cost(forecast_settling(*assembled.scene.relaxation, run)));
    reached = run.state();
}

/// What a stage changes of the one before.
void say_changes(const SceneReading& before, const SceneReading& now, Journal& journal)
{
    std::string text = "  changes of the stage before:";
    for (const std::string& line : changed_keys(before.keys, now.keys)) text += "\n    " + line;
    journal.say(text);
}

/// What the stage will take from the state called `start`; nothing of one that finds a factor of safety.
void say_cost(const SceneReading& stage, const SceneSetup& setup, const std::string& start,
              const ResultsFolder& folder, std::optional<State>& reached, Journal& journal)
{
    const std::optional<SceneStage>& of_stage = stage.scene.stage;
    if (of_stage && settles(of_stage->kind)) return say_settling(setup, reached, journal);
    if (!of_stage || of_stage->kind != StageKind::stability) say_run(setup, start, folder, journal);
}

} // namespace

ExitCode check_scene(const CheckChoice& choice)
{
    Journal journal;
    std::vector<SceneReading> stages = read_stages(choice.scene, journal);
    if (stages.size() > 1) require_sound(stages);
    const SceneSetup setup = set_up_reading(choice.scene, stages.front(), journal);
    const AssembledCase& assembled = setup.assembled;
    const std::vector<PatchTest> patch_tests = test_patches(assembled.problem, assembled.state);
    refuse_failed_patches(assembled, patch_tests);
    const ResultsFolder folder = prepare_report_folder(
        report_folder(choice.directory, assembled.scene.file, "check"), plan_file, assembled.scene);
    journal.keep(folder.directory / plan_file);
    say_stage(stages.front(), 1, stages.size(), journal);
    journal.say(describe_scene_keys(setup));
    journal.say(describe_soil(assembled));
    if (const std::string slip = describe_interfaces(assembled); !slip.empty()) journal.say(slip);
    journal.say(describe_boundaries(assembled, patch_tests));
    if (const std::string laws = describe_laws(assembled); !laws.empty()) journal.say(laws);
    if (const std::string flow = describe_initial_flow(assembled); !flow.empty()) journal.say(flow);
    journal.say(describe_initial_state(assembled));
    std::optional<State> reached; // by the last trial of a settling
    say_cost(stages.front(), setup, "the K0 state as it is", folder, reached, journal);
    for (std::size_t k = 1; k < stages.size(); ++k) {
        say_stage(stages[k], k + 1, stages.size(), journal);
        say_changes(stages[k - 1], stages[k], journal);
        stages[k].parted_before = assembled.water_lines; // as those of the first stage
        const SceneSetup of_stage = set_up_reading(choice.scene, stages[k], journal);
        if (const std::string slip = describe_interfaces(of_stage.assembled); !slip.empty())
            journal.say(slip);
        if (const std::string flow = describe_initial_flow(of_stage.assembled); !flow.empty())
            journal.say(flow);
        say_cost(stages[k], of_stage, "the end of the stage before", folder, reached, journal);
    }
    write_initial_frame(assembled, folder);
    journal.say("The initial state is in " + folder.particle_series().string() + " and " +
                folder.grid_series().string() + "; this plan is in " +
                (folder.directory / plan_file).string());
    return ExitCode::good;
}

} // namespace quicksand
