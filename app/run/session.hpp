// One run from the initial state to its end, a stop or a failure, with its log, checkpoint and manifest.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/journal.hpp"
#include "app/run/scene_setup.hpp"
#include "io/results/results_folder.hpp"

namespace quicksand {

struct SessionOutcome {
    ExitCode code = ExitCode::good;
    bool finished = false; // false: stopped on request or failed
    ResultsFolder folder;
};

/// Run the scene into the results folder. A numerical failure is told, kept in the log and the manifest, and
/// returned; other failures leave the manifest as failed and are thrown on.
SessionOutcome run_session(const RunChoice& choice, SceneSetup setup, Journal& journal);

} // namespace quicksand
