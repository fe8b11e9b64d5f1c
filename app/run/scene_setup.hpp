// From the command line's scene to what the solver runs.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/journal.hpp"
#include "io/assembly/case_assembly.hpp"
#include "solver/run/staged_run.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// By which results know their scene again.
struct SceneHashes {
    std::string scene; // of its text and the overrides
    std::string state; // of the keys that the state hangs on
};

SceneHashes hashes_of(const SceneChoice& choice, const SceneReading& reading);

struct SceneSetup {
    AssembledCase assembled;       // its state is the initial one, before any settling
    std::vector<ResolvedKey> keys; // of the scene, as read
    SceneHashes hashes;
};

/// Set the number of threads, read the scene, draw and sample its section, and print the warnings. Throws
/// InputError.
SceneSetup set_up_scene(const SceneChoice& choice, Journal& journal);

/// The stages of the scene as read, one in a scene without stages; sets the number of threads. Throws
/// InputError.
std::vector<SceneReading> read_stages(const SceneChoice& choice, Journal& journal);

/// Draw and sample the section of a scene as read, and print the warnings. Throws InputError.
SceneSetup set_up_reading(const SceneChoice& choice, SceneReading reading, Journal& journal);

/// How a run of the scene goes.
RunControls run_controls(const Scene& scene);

/// The scene file itself, or the scene.toml of a folder. Throws InputError where there is none.
std::filesystem::path find_scene_file(const std::filesystem::path& scene);

/// --set words for cells of another size over the section that a grid covers.
std::vector<std::string> on_cells_of(double cell_size, const BackgroundGrid& grid);

/// The name of the scene's folder; of a scene that is not called scene.toml, its own.
std::string scene_name(const std::filesystem::path& scene_file);

/// results/FOLDER with the name of the scene's folder; of a scene that is not called scene.toml,
/// results/FOLDER-NAME, so that variants of unlike scenes have folders of their own.
std::filesystem::path default_results(const std::filesystem::path& scene_file);

/// The folder that was chosen for a command's report; when that is empty, default_results() and the command's
/// name behind a hyphen.
std::filesystem::path report_folder(const std::filesystem::path& chosen,
                                    const std::filesystem::path& scene_file, const std::string& command);

} // namespace quicksand
