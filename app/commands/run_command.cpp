#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/results_summary.hpp"
#include "app/run/session.hpp"

namespace quicksand {

ExitCode run_scene(const RunChoice& choice)
{
    Journal journal;
    const SessionOutcome outcome = run_session(choice, set_up_scene(choice.scene, journal), journal);
    if (outcome.end != SessionEnd::finished) return outcome.code();
    journal.say(describe_files(outcome.folder));
    journal.say("Make pictures:\n  quicksand picture " + outcome.folder.directory.string());
    journal.say(summarize_probes(outcome.folder));
    return outcome.code();
}

} // namespace quicksand
