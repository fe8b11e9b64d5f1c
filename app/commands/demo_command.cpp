#include "app/commands/commands.hpp"
#include "app/run/example_folder.hpp"
#include "app/run/journal.hpp"
#include "app/run/results_summary.hpp"
#include "app/run/session.hpp"
#include "io/pictures/picture_set.hpp"

namespace quicksand {

namespace {

constexpr double demo_end =
    0.125; // a peak after six cycles of the shaking, about two minutes on two cores [s]

/// The dike example with the demo's end and closer output.
RunChoice shortened_dike(const DemoChoice& choice)
{
    RunChoice run;
    run.scene.scene = example_folder("dike");
    run.scene.until = demo_end;
    run.scene.threads = choice.threads;
    run.scene.overrides = {"output.frame_interval=2.5e-3", "output.probe_interval=2.5e-4",
                           "output.history_interval=2.5e-4"};
    run.directory = choice.directory;
    run.overwrite = std::filesystem::exists(choice.directory);
    return run;
}

} // namespace

ExitCode run_demo(const DemoChoice& choice)
{
    Journal journal;
    journal.say("The dike example, shortened to its first 0.125 s: about two minutes on two cores.");
    const RunChoice run = shortened_dike(choice);
    const SessionOutcome outcome = run_session(run, set_up_scene(run.scene, journal), journal);
    if (outcome.end != SessionEnd::finished) return outcome.code();
    PictureRequest request;
    request.notify = [&](const std::string& text) { journal.say(text); };
    std::string pictures = "Look at the pictures:";
    for (const auto& file : draw_results(outcome.folder.directory, request))
        pictures += "\n  " + file.string();
    journal.say(pictures);
    journal.say(describe_files(outcome.folder));
    journal.say(summarize_probes(outcome.folder));
    return outcome.code();
}

} // namespace quicksand
