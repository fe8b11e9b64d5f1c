// What a finished run shows for itself: the files to open, the probes and the crest in numbers.
#pragma once

#include "io/results/results_folder.hpp"

#include <string>

namespace quicksand {

/// Peak excess pore pressure, largest r_u and final displacement of every probe, and the crest settlement.
std::string summarize_probes(const ResultsFolder& folder);

/// Which file to open with what.
std::string describe_files(const ResultsFolder& folder);

} // namespace quicksand
