// One run from the initial state to its end, a stop or a failure, with its log, checkpoint and manifest.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/journal.hpp"
#include "app/run/scene_setup.hpp"
#include "io/results/results_folder.hpp"
#include "solver/run/stage_start.hpp"

#include <optional>

namespace quicksand {

enum class SessionEnd { finished, stopped, failed };

struct SessionOutcome {
    SessionEnd end = SessionEnd::finished;
    ResultsFolder folder;
    /// Of the program: a stop is no failure.
    ExitCode code() const { return end == SessionEnd::failed ? ExitCode::numerical : ExitCode::good; }
};

/// Where a run begins that goes on from another one.
struct Origin {
    State reached;
    StageStart start;
    std::vector<std::string> warnings; // of what the stage leaves behind
};

/// Run the scene into the results folder, from the state as drawn or from an origin. A numerical failure is
/// told, kept in the log and the manifest, and returned; other failures leave the manifest as failed and are
/// thrown on.
SessionOutcome run_session(const RunChoice& choice, SceneSetup setup, Journal& journal,
                           std::optional<Origin> origin = std::nullopt);

} // namespace quicksand
