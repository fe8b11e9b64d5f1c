#include "app/commands/commands.hpp"
#include "app/run/flow_text.hpp"
#include "app/run/journal.hpp"
#include "app/run/plan.hpp"
#include "app/run/scene_setup.hpp"
#include "app/run/trial.hpp"
#include "io/results/output_observers.hpp"
#include "io/results/results_folder.hpp"
#include "solver/run/staged_run.hpp"
#include "solver/vibration/step_bound.hpp"

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
         make_output_observers(scene, assembled.problem, state, {folder.directory, "", false})) {
        writer->observe(assembled.problem, state, {0, 0.0, {}, 0});
        writer->finish();
    }
}

} // namespace

ExitCode check_scene(const CheckChoice& choice)
{
    Journal journal;
    const SceneSetup setup = set_up_scene(choice.scene, journal);
    const AssembledCase& assembled = setup.assembled;
    const std::vector<PatchTest> patch_tests = test_patches(assembled.problem, assembled.state);
    refuse_failed_patches(assembled, patch_tests);
    const ResultsFolder folder = prepare_report_folder(
        report_folder(choice.directory, assembled.scene.file, "check"), plan_file, assembled.scene);
    journal.keep(folder.directory / plan_file);
    journal.say(describe_scene_keys(setup));
    journal.say(describe_soil(assembled));
    journal.say(describe_boundaries(assembled, patch_tests));
    if (const std::string laws = describe_laws(assembled); !laws.empty()) journal.say(laws);
    if (const std::string flow = describe_initial_flow(assembled); !flow.empty()) journal.say(flow);
    journal.say(describe_initial_state(assembled));
    if (const std::string shaking = describe_motion(assembled); !shaking.empty()) journal.say(shaking);
    const TimeStep step = measure_time_step(assembled.problem, assembled.state);
    journal.say(describe_time_step(assembled, step));
    const StagedRun run(assembled.problem, assembled.state, run_controls(assembled.scene));
    journal.say(describe_cost(forecast_run(assembled, run, step.dt, folder.directory)));
    journal.say(describe_left_out(assembled.scene, run));
    write_initial_frame(assembled, folder);
    journal.say("The initial state is in " + folder.particle_series().string() + " and " +
                folder.grid_series().string() + "; this plan is in " +
                (folder.directory / plan_file).string());
    return ExitCode::good;
}

} // namespace quicksand
