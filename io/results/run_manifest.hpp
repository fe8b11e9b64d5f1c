// What a run was and how it ended, as run_manifest.json: enough to repeat it and to trust its results.
#pragma once

#include "io/results/documented_name.hpp"
#include "io/results/run_summary.hpp"
#include "io/scene/scene_file.hpp"
#include "io/tables/scene.hpp"
#include "solver/faces/water_condition.hpp"
#include "solver/measure/verdict.hpp"
#include "solver/problem/problem.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// Version of this program, e.g. "0.1.0".
std::string program_version();

/// The model of the first processor, "" when the system does not tell.
std::string processor_name();

/// FNV-1a hash (64 bits) of a text, as 16 hexadecimal digits.
std::string text_hash(std::string_view text);

/// FNV-1a hash (64 bits) of the scene's text and then of each override after a zero byte, as 16 hexadecimal
/// digits. It tells scenes apart; it is no protection against forgery.
std::string scene_hash(std::string_view text, const std::vector<std::string>& overrides);

/// Present time as ISO 8601 in UTC.
std::string utc_now();

/// A file that a key of the scene names, and what it held.
struct InputFile {
    std::string key;            // "geometry.file"; "geometry.file > layers.geo" of one that the drawing opens
    std::filesystem::path file; // resolved against the scene's folder
    std::string hash;           // text_hash() of its bytes
};

/// The drawing with the files that it includes or merges, the record of the base motion and the histories of
/// boundaries, as they are now. Throws FileError, InputError.
std::vector<InputFile> input_files(const Scene& scene, const std::vector<ResolvedKey>& keys);

/// Throws InputError where a file is not what it was when the run of this manifest began. A manifest that
/// tells nothing of a file lets it pass.
void require_same_inputs(const std::filesystem::path& manifest, const std::vector<InputFile>& inputs);

enum class RunStatus { running, finished, failed, stopped };

struct RunManifest {
    RunStatus status = RunStatus::running;
    std::string exit_reason; // one line; empty while running
    std::filesystem::path scene_file;
    std::string scene_hash;
    std::string state_hash;             // text_hash() of state_text(), see io/scene/state_keys.hpp
    std::vector<std::string> overrides; // path=value, as given
    std::vector<InputFile> inputs;
    std::vector<WaterLine> water_lines; // at which particles are parted
    TimeScheme scheme = TimeScheme::explicit_steps;
    int threads = 1;
    std::optional<double> resumed_at; // t of the checkpoint [s]
    std::string start_time;           // UTC; filled by begin_manifest()
    std::string end_time;             // UTC; empty while running
    double wall_time = 0.0;           // of this process [s]
    double simulated_time = 0.0;      // t reached [s]
    std::int64_t steps = 0;           // taken by this process [-]
    std::size_t particles = 0;
    std::int64_t step_halvings = 0;   // by the watchdog [-]
    std::vector<Finding> findings;    // of the verdict; none before the end
    RunSummary summary;               // empty before the end
    std::vector<std::string> outputs; // relative to the results folder
};

/// What stands in the manifest, in its order.
std::vector<DocumentedName> manifest_fields();

/// The manifest at the start of a run: what is known then.
RunManifest begin_manifest(const Scene& scene, const std::vector<std::string>& overrides, int threads,
                           std::size_t particles);

/// The status in the manifest, none where it is missing or damaged. Throws FileError when it cannot be read.
std::optional<RunStatus> read_run_status(const std::filesystem::path& path);

/// How often the watchdog has halved the step, NaN where the manifest does not tell it. Throws FileError.
double read_step_halvings(const std::filesystem::path& path);

/// Write the manifest as JSON, replacing a former one as a whole. Throws FileError.
void write_run_manifest(const std::filesystem::path& path, const RunManifest& manifest);

} // namespace quicksand
