// A sweep's runs as files for programs that spread work over machines.
#pragma once

#include "app/sweep/sweep_plan.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// The words as a line for a shell, each in single quotes where it needs them.
std::string shell_line(const std::vector<std::string>& words);

/// Write commands.txt and the file of the engine ("parallel", "slurm" or "snakemake") into the sweep's
/// folder; what to type then. Throws FileError.
std::string write_engine_files(const SweepPlan& plan, std::string_view engine);

} // namespace quicksand
