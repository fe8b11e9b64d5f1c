// The verdict on a run by its history: a line for the log, and what the manifest keeps.
#pragma once

#include "io/results/results_folder.hpp"
#include "solver/measure/verdict.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace quicksand {

/// The criteria that the run's history.csv has values of. Throws FileError.
std::vector<Finding> judge_history(const ResultsFolder& folder);

/// "Verdict: good, energy error 6e-5, ..." with what keeps it from being good, and how often the watchdog has
/// halved the step.
std::string describe_verdict(const std::vector<Finding>& findings, std::int64_t step_halvings);

/// What went bad, when, and what to do, where the verdict is bad.
std::string explain_bad_verdict(const std::vector<Finding>& findings);

} // namespace quicksand
