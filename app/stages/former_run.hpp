// What --continue and --resume find in a results folder.
#pragma once

#include "app/run/choices.hpp"
#include "io/results/results_folder.hpp"

#include <string>

namespace quicksand {

/// Another run's results are left as they are, and refused later.
enum class FormerRun { none, finished, with_checkpoint, without_checkpoint };

/// Of the run whose scene has this hash. Throws InputError, FileError.
FormerRun former_run(const ResultsFolder& folder, const std::string& hash);

/// Let the run go on from the checkpoint of an unfinished former one, or replace one without a checkpoint.
void take_up(FormerRun former, RunChoice& choice);

} // namespace quicksand
