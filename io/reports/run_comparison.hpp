// Runs side by side: their histories over each other, and a table of peaks, final values and differences.
#pragma once

#include "io/pictures/picture_gnuplot.hpp"
#include "io/pictures/picture_probes.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// The histories of a run: that of the body, called "history", and those of its probes.
struct ComparedRun {
    std::string name; // the folder's; with its parents' where others are called the same
    std::filesystem::path folder;
    std::vector<ProbeTable> tables; // over time: profiles are left out
};

/// Read the histories of results. Throws InputError where a folder holds none or is named twice, and
/// FileError.
std::vector<ComparedRun> read_compared_runs(const std::vector<std::filesystem::path>& folders);

/// A quantity of one run beside that of the first.
struct ComparedValue {
    std::string table;         // "history" or a probe
    std::string column;        // "crest_settlement_m"
    std::string run;           // its name
    double peak = 0.0;         // the value that is largest in amount, with its sign
    double peak_time = 0.0;    // [s]
    double final_value = 0.0;  // the last one
    double peak_change = 0.0;  // in amount, against the first run that has it; NaN of that run itself
    double final_change = 0.0; // likewise
    double rms_difference =
        0.0; // over the times of that run that both have, which are interpolated; likewise
};

/// All columns that two of the runs or more have, or the only one, in the order of the first run's files and
/// columns.
std::vector<ComparedValue> compare_runs(const std::vector<ComparedRun>& runs);

/// The values as a table, one row a run and a quantity. Throws FileError.
void write_comparison(const std::filesystem::path& path, const std::vector<ComparedValue>& values,
                      const std::vector<std::string>& comments);

/// Whether a quantity is among those that are drawn, and so worth a line on the terminal.
bool is_drawn(const ComparedValue& value);

/// The histories of the runs over each other, one picture a table, for files in `folder`.
std::vector<Drawing> comparison_drawings(const std::vector<ComparedRun>& runs,
                                         const std::filesystem::path& folder);

} // namespace quicksand
