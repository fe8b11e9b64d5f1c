// A run's manifest read back.
#pragma once

#include "io/results/run_summary.hpp"
#include "solver/faces/water_condition.hpp"
#include "solver/problem/problem.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// What reports need of run_manifest.json; empty or zero where the file does not tell it.
struct RunRecord {
    std::string version, status, exit_reason, verdict;
    std::filesystem::path scene_file;
    std::string scene_hash, state_hash;
    std::vector<std::string> overrides; // path=value, as given
    /// At which particles are parted; none in a manifest that does not tell it.
    std::optional<std::vector<WaterLine>> water_lines;
    std::optional<TimeScheme> scheme;             // none in a manifest that does not tell it
    std::string start_time, end_time;             // UTC
    double wall_time = 0.0;                       // of the last process [s]
    double simulated_time = 0.0;                  // t reached [s]
    double steps = 0.0;                           // taken by the last process [-]
    double particles = 0.0;                       // [-]
    double threads = 0.0;                         // [-]
    double step_halvings = 0.0;                   // [-]
    std::map<std::string, double> largest_errors; // by quantity; NaN where there was no number
    std::vector<SummaryValue> summary;            // in the order of the file; empty before the end
};

/// Throws InputError where the folder of the file holds no run or the file is damaged, and FileError.
RunRecord read_run_record(const std::filesystem::path& manifest);

} // namespace quicksand
