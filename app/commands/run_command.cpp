#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/results_summary.hpp"
#include "app/stages/staged_session.hpp"

namespace quicksand {

ExitCode run_scene(const RunChoice& choice)
{
    Journal journal;
    const SessionOutcome outcome = run_stages(choice, read_stages(choice.scene, journal), journal);
    if (outcome.end != SessionEnd::finished || outcome.folder.directory.empty()) return outcome.code();
    if (!std::filesystem::exists(outcome.folder.manifest()))
        return outcome.code(); // of a search for a factor
    journal.say(describe_files(outcome.folder));
    journal.say("Make pictures:\n  quicksand picture " + outcome.folder.directory.string());
    journal.say(summarize_probes(outcome.folder));
    return outcome.code();
}

} // namespace quicksand
