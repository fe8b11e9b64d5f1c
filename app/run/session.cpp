#include "app/run/session.hpp"

#include "app/run/flow_text.hpp"
#include "app/run/motion_text.hpp"
#include "app/run/number_format.hpp"
#include "app/run/plan.hpp"
#include "app/run/progress_line.hpp"
#include "app/run/run_verdict.hpp"
#include "app/run/stop_signal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/reports/settling_evidence.hpp"
#include "io/reports/summary_reading.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/output_observers.hpp"
#include "io/results/run_manifest.hpp"
#include "io/results/run_record.hpp"
#include "io/scene/scene_keys.hpp"
#include "io/scene/state_keys.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

/// The manifest on disk, kept true at every turn of the run.
class ManifestKeeper {
public:
    ManifestKeeper(std::filesystem::path path, RunManifest manifest)
        : path_(std::move(path)), manifest_(std::move(manifest)), began_(std::chrono::steady_clock::now())
    {
        write_run_manifest(path_, manifest_);
    }
    void reach(const State& state, std::int64_t steps)
    {
        manifest_.simulated_time = state.time;
        manifest_.step_halvings = state.times_halved;
        manifest_.steps = steps;
    }
    void summarize(RunSummary summary) { manifest_.summary = std::move(summary); }
    void judge(const std::vector<Finding>& findings) { manifest_.findings = findings; }
    void end(RunStatus status, const std::string& reason)
    {
        manifest_.status = status;
        manifest_.exit_reason = reason.substr(0, reason.find('\n'));
        manifest_.end_time = utc_now();
        manifest_.wall_time =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
        write_run_manifest(path_, manifest_);
    }
    /// On the way out of another failure, which is the one to be told.
    void end_quietly(const std::string& reason)
    {
        try {
            end(RunStatus::failed, reason);
        } catch (const FileError&) {
        }
    }

private:
    std::filesystem::path path_;
    RunManifest manifest_;
    std::chrono::steady_clock::time_point began_;
};

/// Everything the run needs at hand.
struct Session {
    const Scene& scene;
    StagedRun& run;
    const SceneHashes& hashes;
    ResultsFolder folder;
    bool resume = false;
    bool resumes_shaking = false; // some of its results are there
    Journal& journal;
    ManifestKeeper& manifest;
    std::string flow;                      // of the ground water at the start, "" where it is still
    std::vector<std::string> changes = {}; // of a scene that goes on, since it began
};

std::string say_where_good(const ResultsFolder& folder)
{
    std::string text;
    const std::vector<FrameEntry> frames = std::filesystem::exists(folder.particle_series())
                                               ? read_series_index(folder.particle_series())
                                               : std::vector<FrameEntry>();
    if (!frames.empty()) {
        text += fmt::format("\n  last good frame: {} (t = {} s)",
                            (folder.directory / frames.back().file).string(),
                            short_number(frames.back().time, 6));
    }
    if (std::filesystem::exists(folder.checkpoint())) {
        text += "\n  last checkpoint: " + folder.checkpoint().string() + " (go on from it with --resume)";
    }
    return text;
}

void keep_state(const Session& session)
{
    std::filesystem::create_directories(session.folder.checkpoint().parent_path());
    write_checkpoint(session.folder.checkpoint(), session.run.state(), session.hashes.state);
}

/// The soil that has not come to rest, for its user to look at; in lines for the log.
std::string show_unsettled(const Session& session)
{
    const Scene& scene = session.scene;
    return leave_settling_evidence(session.folder, scene.title, session.run.body(),
                                   session.run.state_of_body());
}

void begin_unsettled(Session& session)
{
    const std::size_t limited = session.run.begin_shaking();
    if (limited == 0) return;
    session.journal.say(fmt::format("The initial stress of {} particles was beyond what their sand can "
                                    "carry, or below its stress floor, and has been brought back to it.",
                                    grouped(static_cast<long long>(limited))));
}

/// Settle, or keep what is reached at a stop.
void settle(Session& session, const RelaxationControls& controls)
{
    ProgressLine progress(0.0, session.scene.end_time, session.run.state().particles.size(), session.journal);
    using WallClock = std::chrono::steady_clock;
    const std::chrono::duration<double> interval(session.scene.output.checkpoint_interval);
    auto last = WallClock::now();
    const auto look_on = [&](const SettlingProgress& settling) {
        progress.show_relaxation(settling, controls.tolerance);
        if (WallClock::now() - last <= interval) return;
        keep_state(session);
        last = WallClock::now();
    };
    const RelaxationReport report = session.run.settle(controls, look_on, StopSignal::received);
    progress.clear();
    if (!report.settled) {
        keep_state(session);
        session.journal.say(fmt::format("Stopped at step {} of the settling: {}", grouped(report.steps),
                                        unbalanced_text(report.unbalanced, controls.tolerance)) +
                            show_unsettled(session));
        return;
    }
    remove_settling_evidence(session.folder);
    session.journal.say(fmt::format(
        "Settled in {} steps, {}: out-of-balance force {} of the weight, displacement up to "
        "{} mm, which counts as zero from here",
        report.steps, duration_text(progress.elapsed()), short_number(report.unbalanced.of_weight, 2),
        short_number(1e3 * report.max_displacement, 2)));
    if (report.at_failure > 0) {
        session.journal.say(fmt::format("{} particles have settled at the failure limit of their sand",
                                        grouped(static_cast<long long>(report.at_failure))));
    }
}

/// `begins` the shaking, or goes on with it.
void shake(Session& session, bool begins)
{
    StagedRun& run = session.run;
    if (begins) keep_state(session); // from here a stop or a failure need not settle the soil again
    const OutputSettings settings{session.folder.directory, session.hashes.scene, session.hashes.state,
                                  !begins, &run.state()};
    const auto writers = make_output_observers(session.scene, run.body(), run.state_of_body(), settings);
    ProgressLine progress(run.state().time, session.scene.end_time, run.state().particles.size(),
                          session.journal);
    std::vector<Observer*> observers;
    for (const auto& writer : writers) observers.push_back(writer.get());
    observers.push_back(&progress);
    try {
        run.shake(observers, StopSignal::received);
    } catch (...) {
        progress.clear();
        session.manifest.reach(run.state(), progress.steps());
        throw;
    }
    progress.clear();
    session.manifest.reach(run.state(), progress.steps());
    keep_state(session);
    if (begins && progress.steps() == 0) return; // settled, and shown
    if (!begins && progress.steps() == 0) {
        session.journal.say(fmt::format(
            "No step was left: the results reach t = {} s, and what was missing at their end is written.",
            short_number(run.state().time, 6)));
        return;
    }
    const double seconds = progress.elapsed();
    const double work =
        static_cast<double>(run.state().particles.size()) * static_cast<double>(progress.steps());
    session.journal.say(fmt::format("Ran {} steps to t = {} s in {}: {} particle-steps/s",
                                    grouped(progress.steps()), short_number(run.state().time, 6),
                                    duration_text(seconds), short_number(work / seconds, 2)));
}

/// Open the log and say what is run. The manifest is there already: a folder with a log alone would belong to
/// nobody, and neither `run` nor `run --overwrite` would take it.
void introduce(Session& session)
{
    const Scene& scene = session.scene;
    const StagedRun& run = session.run;
    const BackgroundGrid& grid = run.problem().grid;
    if (session.resume) {
        session.journal.go_on_with(session.folder.log());
    } else {
        session.journal.keep(session.folder.log());
    }
    session.journal.say(fmt::format(
        "{}{}\n{} particles, {} x {} cells of {} m, {}; results in {}",
        session.resume ? "Going on with " : "", scene.title.empty() ? scene.file.string() : scene.title,
        grouped(static_cast<long long>(run.state().particles.size())), grid.cells_x, grid.cells_y,
        short_number(grid.cell_size), threads_text(thread_count()), session.folder.directory.string()));
    for (const std::string& change : session.changes)
        session.journal.say("  changed since the run began: " + change);
    if (!session.flow.empty()) session.journal.say(session.flow);
    if (!scene.stage || scene.stage->kind == StageKind::shake)
        for (const std::string& warning : warnings_of_motion(scene)) session.journal.say(warning);
    if (run.column()) session.journal.say(describe_column(*run.column()));
}

SessionEnd end_at_stop(Session& session)
{
    const bool shaking = session.run.is_shaking();
    session.manifest.end(RunStatus::stopped,
                         shaking ? "stopped on request" : "stopped on request while settling");
    session.journal.say(
        (shaking ? fmt::format("Stopped on request at t = {} s.", short_number(session.run.state().time, 6))
                 : "\nStopped on request while settling.") +
        " Go on with the same command and --resume.");
    return SessionEnd::stopped;
}

/// The run has reached its end; whether it is a good one its own balances say.
SessionEnd end_with_verdict(Session& session)
{
    const std::vector<Finding> findings = judge_history(session.folder);
    session.manifest.judge(findings);
    session.manifest.summarize(summarize_run(session.folder.directory));
    if (worst_grade(findings) == Grade::bad) {
        const std::string reason = explain_bad_verdict(findings);
        session.manifest.end(RunStatus::failed, reason);
        session.journal.complain(reason);
        return SessionEnd::failed;
    }
    session.journal.say(describe_verdict(findings, session.run.state().times_halved));
    session.manifest.end(RunStatus::finished, "reached the end time");
    return SessionEnd::finished;
}

SessionEnd run_stages(Session& session)
{
    const StopSignal signal;
    introduce(session);
    const std::optional<RelaxationControls>& relaxation = session.scene.relaxation;
    const bool goes_on = session.run.is_shaking(); // from a checkpoint or another stage
    if (!goes_on && relaxation) settle(session, *relaxation);
    if (!goes_on && !relaxation) begin_unsettled(session);
    if (session.run.is_shaking()) shake(session, !session.resumes_shaking);
    if (!session.run.is_finished()) return end_at_stop(session);
    return end_with_verdict(session);
}

/// Whether a run to the end time would find nothing to do. A run that was killed over its last rows or its
/// last frame has a checkpoint of the end time as well, but its manifest does not call it finished.
bool is_complete(const ResultsFolder& folder, const StagedRun& run, double end_time)
{
    if (!run.is_finished()) return false;
    return run.state().time > end_time || read_run_status(folder.manifest()) == RunStatus::finished;
}

/// The keys of the scene that the folder's run began with; none where the folder does not tell them.
std::vector<ResolvedKey> keys_at_beginning(const ResultsFolder& folder)
{
    if (!std::filesystem::exists(folder.manifest()) || !std::filesystem::exists(folder.scene_copy()))
        return {};
    return read_scene_keys(folder.scene_copy(), read_run_record(folder.manifest()).overrides);
}

[[noreturn]] void refuse(const ResultsFolder& folder, const std::vector<std::string>& changes)
{
    std::string lines;
    for (const std::string& change : changes) lines += "\n  " + change;
    throw InputError(
        folder.directory.string() +
        " cannot be resumed, for its state hangs on what has changed since the run began:" + lines +
        "\nexpected: the same scene and --set values; only title, figures, relaxation.tolerance, "
        "relaxation.max_steps, run.end_time, durations and intervals of output may be others"
        "\nhint: begin anew with --overwrite, or in another folder with -o");
}

/// The state that a run goes on from, and what its user changed of when it ends and what it reports.
struct Resumption {
    State kept;
    std::vector<std::string> changes; // "relaxation.tolerance: 1e-6 -> 1e-5"
};

/// Read the checkpoint in the folder, whose copy of the scene then becomes the present one. Throws InputError
/// where the state hangs on a key or an input file that has changed since the run began, and FileError.
Resumption resume_run(const ResultsFolder& folder, const SceneSetup& setup,
                      const std::vector<InputFile>& inputs)
{
    const std::vector<ResolvedKey> before = keys_at_beginning(folder);
    const bool is_told = !before.empty();
    std::vector<std::string> changes = state_changes(before, setup.keys);
    const bool is_same = read_run_record(folder.manifest()).state_hash == setup.hashes.state;
    if (is_told && changes.empty() && !is_same) // all that the hash has besides the keys
        changes.emplace_back("no key: histories that later stages ask for, or the program's version");
    if (is_told && !changes.empty()) refuse(folder, changes);
    Resumption resumption{read_checkpoint(folder.checkpoint(), setup.hashes.state), {}};
    require_same_inputs(folder.manifest(), inputs);
    if (is_told) resumption.changes = report_changes(before, setup.keys);
    if (const std::string& text = setup.assembled.scene.text;
        !std::filesystem::exists(folder.scene_copy()) || read_text(folder.scene_copy()) != text)
        write_atomically(folder.scene_copy(), text);
    return resumption;
}

SessionEnd run_guarded(Session& session)
{
    try {
        return run_stages(session);
    } catch (const NumericalError& error) {
        session.manifest.end_quietly(error.what());
        const auto& relaxation = session.scene.relaxation;
        const State& state = session.run.state();
        const bool took_all_steps =
            !session.run.is_shaking() && relaxation && state.step >= relaxation->max_steps;
        if (took_all_steps) keep_state(session); // it may go on to a looser tolerance
        const std::string unsettled = session.run.is_shaking() ? "" : show_unsettled(session);
        session.journal.complain(error.what() + unsettled + say_where_good(session.folder));
        return SessionEnd::failed;
    } catch (const std::exception& error) {
        session.manifest.end_quietly(error.what());
        session.journal.note_failure(error.what());
        throw;
    }
}

} // namespace

SessionOutcome run_session(const RunChoice& choice, SceneSetup setup, Journal& journal,
                           std::optional<Origin> origin)
{
    const Scene& scene = setup.assembled.scene;
    const FolderUse use = choice.resume      ? FolderUse::resume
                          : choice.overwrite ? FolderUse::overwrite
                                             : FolderUse::fresh;
    const auto directory = choice.directory.empty() ? default_results(scene.file) : choice.directory;
    std::optional<StagedRun> run;
    const auto begin = [&](std::optional<State> kept) {
        run.emplace(setup.assembled.problem, std::move(setup.assembled.state), run_controls(scene),
                    std::move(kept));
    };
    if (!choice.resume) begin(std::nullopt);
    if (!choice.resume && origin) run->go_on_from(std::move(origin->reached), origin->start);
    SessionOutcome outcome; // a start that is refused has left no folder
    outcome.folder = prepare_results_folder(directory, scene, use);
    Resumption resumption;
    const std::vector<InputFile> inputs = input_files(scene, setup.keys);
    if (choice.resume) {
        resumption = resume_run(outcome.folder, setup, inputs);
        begin(std::move(resumption.kept));
    }
    const State& state = run->state();
    RunManifest manifest =
        begin_manifest(scene, choice.scene.overrides, thread_count(), state.particles.size());
    manifest.inputs = inputs;
    manifest.state_hash = setup.hashes.state;
    manifest.water_lines = setup.assembled.water_lines;
    manifest.scheme = setup.assembled.problem.scheme;
    const bool resumes_shaking = choice.resume && run->is_shaking();
    if (resumes_shaking) manifest.resumed_at = state.time;
    if (is_complete(outcome.folder, *run, scene.end_time)) {
        journal.go_on_with(outcome.folder.log());
        journal.say(
            fmt::format("Nothing to do: the results reach t = {} s already.", short_number(state.time, 6)));
        return outcome;
    }
    ManifestKeeper keeper(outcome.folder.manifest(), std::move(manifest));
    Session session{scene,
                    *run,
                    setup.hashes,
                    outcome.folder,
                    choice.resume,
                    resumes_shaking,
                    journal,
                    keeper,
                    summarise_initial_flow(setup.assembled),
                    std::move(resumption.changes)};
    outcome.end = run_guarded(session);
    return outcome;
}

} // namespace quicksand
