// A run of a scene in its stages, each with a results folder of its own, or of a scene without stages.
#pragma once

#include "app/run/session.hpp"

#include <vector>

namespace quicksand {

/// Run all stages as read, from the first or from results that the choice names. A stage that is finished is
/// not run again with --resume or --continue. The outcome is that of the last stage that ran.
SessionOutcome run_stages(const RunChoice& choice, std::vector<SceneReading> stages, Journal& journal);

} // namespace quicksand
