// What --continue and --resume find in a results folder.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/scene_setup.hpp"
#include "io/results/results_folder.hpp"

namespace quicksand {

/// Another run's results are left as they are, and refused later.
enum class FormerRun { none, finished, with_checkpoint, without_checkpoint };

/// Of the run whose state hangs on keys of this hash; finished where its scene has not changed otherwise.
/// Throws InputError, FileError.
FormerRun former_run(const ResultsFolder& folder, const SceneHashes& hashes);

/// Let the run go on from the checkpoint of an unfinished former one, or replace one without a checkpoint.
void take_up(FormerRun former, RunChoice& choice);

} // namespace quicksand
