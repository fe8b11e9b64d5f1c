// Stages of a run in one table, stages.csv, and their frames in one series, stages.pvd, beside the folders of
// the stages.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// What a stage came to.
struct StageRow {
    std::string name;                            // and folder within that of the run
    std::string kind;                            // as scenes call it
    std::string status;                          // as in run_manifest.json
    double start = 0.0;                          // on the clock of all stages [s]
    double duration = 0.0;                       // [s]
    std::optional<double> factor_of_safety = {}; // of a stage that looks for it; 0.. [-]
};

/// The table of a run; empty where the folder holds none. Throws FileError, InputError for a damaged one.
std::vector<StageRow> read_stage_table(const std::filesystem::path& results);

/// Write the table, and the frames of all its stages as one series. Throws FileError.
void write_stage_table(const std::filesystem::path& results, const std::vector<StageRow>& stages);

/// The folders of the stages of a run up to that of a stage, which comes last; `results` alone where they are
/// no stage. Throws as read_stage_table().
std::vector<std::filesystem::path> stages_up_to(const std::filesystem::path& results);

/// The folder of a stage whose end another run can go on from: the results themselves, or in a run with
/// stages that of the last one which is a run in time or a settling.
std::filesystem::path with_end(const std::filesystem::path& results);

/// The folder in which commands that show results look: the results themselves, or of a run with stages the
/// last one that shakes, else with_end().
std::filesystem::path with_histories(const std::filesystem::path& results);

} // namespace quicksand
