// What the runs of a sweep came to, as tables.
#pragma once

#include "io/results/run_summary.hpp"
#include "io/sweeps/sweep_runs.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

struct SweepOutcome {
    CheckedRun checked;
    std::string state;      // finished, failed, stopped, running (or killed), missing, other
    std::string verdict;    // good, usable or bad; empty before the end
    std::string reason;     // of a failure
    double wall_time = 0.0; // [s]
    std::vector<SummaryValue> summary;
};

/// Read the manifests in the sweep's folder. A folder of another scene or other words after --set is "other".
/// Throws FileError.
std::vector<SweepOutcome> read_outcomes(const std::vector<CheckedRun>& runs,
                                        const std::filesystem::path& folder);

/// "crest_settlement_m_peak" of the history, "upper.ux_m_peak" of a probe.
std::string column_of(const SummaryValue& value, const std::string& kind);

/// The run's value of a column of sweep.csv, by its name without _peak or with _final; NaN where there is
/// none.
double value_of(const SweepOutcome& outcome, const std::string& quantity);

/// The names without _peak that the runs have values of.
std::vector<std::string> quantities_of(const std::vector<SweepOutcome>& outcomes);

/// "motion.amplitude_m_s2", as a column is called.
std::string column_of(const VariedKey& key, const RunValue& value);

/// runs.csv: number, folder and values of every run. Throws FileError.
void write_runs_csv(const std::filesystem::path& path, const Sweep& sweep,
                    const std::vector<CheckedRun>& runs);

/// sweep.csv: the same, with state, verdict, and peak and final value of each quantity. Throws FileError.
void write_sweep_csv(const std::filesystem::path& path, const Sweep& sweep,
                     const std::vector<SweepOutcome>& outcomes);

} // namespace quicksand
