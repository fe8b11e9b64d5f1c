// One row in this process, as `quicksand run` runs a scene.
#pragma once

#include "app/run/choices.hpp"
#include "app/stress/rows/row_files.hpp"

namespace quicksand {

/// Run the row whose scene and drawing are written, and measure its largest stable step where it asks for it.
/// Throws what a run of the scene throws.
ExitCode run_row(const StressRow& row, const RowFiles& files);

} // namespace quicksand
