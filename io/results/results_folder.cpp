#include "io/results/results_folder.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "io/frames/vtk_series.hpp"
#include "solver/base/failure.hpp"

#include <array>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// In the order of their removal. The manifest goes last, for --overwrite cleans no folder without it: a kill
/// in between leaves one that can be overwritten.
constexpr std::array single_files{"fields.pvd",       "grid.pvd", "history.csv",
                                  "steps.csv",        "log.txt",  "checkpoint/state.h5",
                                  "run_manifest.json"};

/// First file or folder of a former run, "" when there is none.
std::string trace_of_former_run(const fs::path& directory)
{
    for (const char* name : single_files)
        if (fs::exists(directory / name)) return name;
    return {};
}

bool holds_other_scene(const ResultsFolder& folder, const Scene& scene)
{
    return fs::exists(folder.scene_copy()) && read_text(folder.scene_copy()) != scene.text;
}

/// Our CSV files say so in their first line.
bool is_probe(const fs::path& file)
{
    std::string line;
    std::ifstream stream(file);
    return file.extension() == ".csv" && std::getline(stream, line) && line.starts_with("# Quicksand ");
}

void remove_file(const fs::path& file)
{
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError(file, "cannot remove the file of the former run", error.message(), "");
}

template <class Ours>
void remove_in(const fs::path& folder, Ours&& ours)
{
    if (!fs::is_directory(folder)) return;
    std::vector<fs::path> files;
    for (const auto& item : fs::directory_iterator(folder)) files.push_back(item.path());
    for (const fs::path& file : files)
        if (ours(file)) remove_file(file);
    // A folder with the user's own files stays.
    if (fs::is_empty(folder)) remove_file(folder);
}

void remove_series(const fs::path& index)
{
    // The index first: a kill in between leaves no entry without a frame.
    remove_file(temporary_name(index));
    remove_file(index);
    remove_in(fs::path(index).replace_extension(), is_frame_file);
}

void remove_former_run(const ResultsFolder& folder)
{
    const fs::path& directory = folder.directory;
    remove_frames(folder);
    remove_settling_evidence(folder);
    remove_in(directory / "probes", is_probe);
    remove_in(directory / "checkpoint",
              [](const fs::path& file) { return file.filename().string().starts_with("state.h5"); });
    remove_file(folder.scene_copy());
    for (const char* name : single_files) {
        remove_file(temporary_name(directory / name));
        remove_file(directory / name);
    }
}

/// What can be done about a former run: --resume needs its checkpoint, --overwrite its manifest.
std::string advice(const ResultsFolder& folder)
{
    std::string text = "Choose another folder";
    if (fs::exists(folder.checkpoint())) text += ", or run with --resume to go on with it";
    if (fs::exists(folder.manifest())) text += ", or run with --overwrite to replace it";
    return text;
}

void require_empty(const ResultsFolder& folder, const Scene& scene)
{
    std::string trace = trace_of_former_run(folder.directory);
    if (trace.empty() && holds_other_scene(folder, scene)) trace = "scene.toml";
    if (!trace.empty())
        throw InputError(folder.directory.string() + " holds a former run (" + trace + "). " +
                         advice(folder));
}

/// Only a folder with a manifest is surely ours to clean.
void require_ours(const ResultsFolder& folder, const Scene& scene)
{
    const bool anything = !trace_of_former_run(folder.directory).empty() || holds_other_scene(folder, scene);
    if (anything && !fs::exists(folder.manifest()))
        throw InputError(folder.directory.string() +
                         " has no run_manifest.json, so it may not be Quicksand's results: "
                         "nothing was removed. Choose another folder");
}

void require_place_for_results(const ResultsFolder& folder, const Scene& scene)
{
    const std::string name = folder.directory.string();
    if (fs::exists(folder.directory) && !fs::is_directory(folder.directory))
        throw InputError(name + " is a file, not a folder for results");
    std::error_code error;
    if (fs::equivalent(folder.scene_copy(), scene.file, error))
        throw InputError(name + " is the scene's own folder: choose another one for the results");
}

void require_checkpoint(const ResultsFolder& folder)
{
    if (!fs::exists(folder.checkpoint()))
        throw InputError(folder.directory.string() + " cannot be resumed: there is no " +
                         folder.checkpoint().lexically_relative(folder.directory).string());
}

} // namespace

void remove_frames(const ResultsFolder& folder)
{
    for (const fs::path& index : {folder.particle_series(), folder.grid_series()}) remove_series(index);
}

void remove_settling_evidence(const ResultsFolder& folder)
{
    remove_series(folder.settling_series());
    remove_file(folder.settling_picture());
}

ResultsFolder prepare_results_folder(const fs::path& directory, const Scene& scene, FolderUse use)
{
    ResultsFolder folder{directory};
    require_place_for_results(folder, scene);
    if (fs::exists(directory)) folder.lock = std::make_shared<const FolderLock>(directory);
    if (use == FolderUse::resume) {
        require_checkpoint(folder);
        return folder;
    }
    if (use == FolderUse::fresh) {
        require_empty(folder, scene);
    } else {
        require_ours(folder, scene);
        remove_former_run(folder);
    }
    std::error_code error;
    fs::create_directories(directory, error);
    if (error) throw FileError(directory, "cannot create the folder", error.message(), "");
    if (!folder.lock) folder.lock = std::make_shared<const FolderLock>(directory);
    write_atomically(folder.scene_copy(), scene.text);
    return folder;
}

void require_no_former_run(const fs::path& directory, const Scene& scene)
{
    require_empty({directory}, scene);
}

ResultsFolder prepare_report_folder(const fs::path& directory, const std::string& report, const Scene& scene)
{
    ResultsFolder folder{directory};
    // A report without frames leaves room for a run, whose results are not the report's to replace.
    if (!fs::exists(directory / report) || fs::exists(folder.manifest()))
        return prepare_results_folder(directory, scene, FolderUse::fresh);
    require_place_for_results(folder, scene);
    folder.lock = std::make_shared<const FolderLock>(directory);
    write_atomically(folder.scene_copy(), scene.text);
    return folder;
}

} // namespace quicksand
