// The folder of one run's results: where everything lies, and whose files may be removed.
#pragma once

#include "io/files/folder_lock.hpp"
#include "io/tables/scene.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace quicksand {

enum class FolderUse {
    fresh,     // must not hold a former run
    overwrite, // a former run is removed: what Quicksand wrote, nothing else
    resume,    // must hold a checkpoint
};

/// Paths in a results folder.
struct ResultsFolder {
    std::filesystem::path directory;
    std::shared_ptr<const FolderLock> lock = {}; // of a folder made ready for a run
    std::filesystem::path manifest() const { return directory / "run_manifest.json"; }
    std::filesystem::path scene_copy() const { return directory / "scene.toml"; }
    std::filesystem::path log() const { return directory / "log.txt"; }
    std::filesystem::path particle_series() const { return directory / "fields.pvd"; }
    std::filesystem::path grid_series() const { return directory / "grid.pvd"; }
    /// Of soil that did not come to rest.
    std::filesystem::path settling_series() const { return directory / "settling.pvd"; }
    std::filesystem::path settling_picture() const { return directory / "settling.png"; }
    std::filesystem::path history() const { return directory / "history.csv"; }
    std::filesystem::path steps() const { return directory / "steps.csv"; }
    std::filesystem::path probe(const std::string& name) const
    {
        return directory / "probes" / (name + ".csv");
    }
    std::filesystem::path checkpoint() const { return directory / "checkpoint" / "state.h5"; }
};

/// Make the folder ready, copy the scene into it and keep other runs out for as long as the result lives.
/// Throws InputError when `use` does not fit what the folder holds or another run writes to it, and
/// FileError.
ResultsFolder prepare_results_folder(const std::filesystem::path& directory, const Scene& scene,
                                     FolderUse use);

/// Throws InputError where a fresh run could not have the folder.
void require_no_former_run(const std::filesystem::path& directory, const Scene& scene);

/// The folder of a report, which replaces a former one of its name, but no results of a run.
ResultsFolder prepare_report_folder(const std::filesystem::path& directory, const std::string& report,
                                    const Scene& scene);

/// Remove fields.pvd, grid.pvd and their frames, where there are any. Throws FileError.
void remove_frames(const ResultsFolder& folder);

/// Remove what a settling that failed or was stopped left to look at, where there is any. Throws FileError.
void remove_settling_evidence(const ResultsFolder& folder);

} // namespace quicksand
