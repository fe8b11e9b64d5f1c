#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/results_summary.hpp"
#include "app/run/session.hpp"
#include "io/results/run_record.hpp"

namespace quicksand {

namespace {

/// What --continue comes to in a folder. Another run's results are left as they are, and refused later.
enum class FormerRun { none, finished, with_checkpoint, without_checkpoint };

FormerRun former_run(const ResultsFolder& folder, const std::string& hash)
{
    if (!std::filesystem::exists(folder.manifest())) return FormerRun::none;
    const RunRecord record = read_run_record(folder.manifest());
    if (record.scene_hash != hash) return FormerRun::none;
    if (record.status == "finished") return FormerRun::finished;
    return std::filesystem::exists(folder.checkpoint()) ? FormerRun::with_checkpoint
                                                        : FormerRun::without_checkpoint;
}

} // namespace

ExitCode run_scene(const RunChoice& choice)
{
    Journal journal;
    SceneSetup setup = set_up_scene(choice.scene, journal);
    RunChoice chosen = choice;
    if (choice.go_on) {
        if (chosen.directory.empty()) chosen.directory = default_results(setup.assembled.scene.file);
        const FormerRun former = former_run({chosen.directory}, setup.hash);
        chosen.resume = former == FormerRun::with_checkpoint;
        chosen.overwrite = former == FormerRun::without_checkpoint;
        if (former == FormerRun::finished) {
            journal.say("Nothing to do: the run in " + chosen.directory.string() + " is finished.");
            return ExitCode::good;
        }
    }
    const SessionOutcome outcome = run_session(chosen, std::move(setup), journal);
    if (outcome.end != SessionEnd::finished) return outcome.code();
    journal.say(describe_files(outcome.folder));
    journal.say("Make pictures:\n  quicksand picture " + outcome.folder.directory.string());
    journal.say(summarize_probes(outcome.folder));
    return outcome.code();
}

} // namespace quicksand
