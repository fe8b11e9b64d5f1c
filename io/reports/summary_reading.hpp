// The summary of a run, read from its histories and its last frame.
#pragma once

#include "io/results/run_summary.hpp"

#include <filesystem>

namespace quicksand {

/// Peaks and final values of what the pictures of history and probes show, and the largest values in the last
/// frame. What a folder does not hold is left out. Throws FileError.
RunSummary summarize_run(const std::filesystem::path& results);

} // namespace quicksand
