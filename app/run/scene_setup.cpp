#include "app/run/scene_setup.hpp"

#include "io/results/run_manifest.hpp"
#include "io/scene/state_keys.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

void start_threads(int threads, Journal& journal)
{
    constexpr int bearable = 4; // threads a processor [-]
    if (threads > bearable * processor_count())
        journal.complain(
            fmt::format("warning: {0} threads share the machine's processors ({1}): the run takes "
                        "longer than with --threads {1}",
                        threads, processor_count()));
    set_thread_count(threads);
}

} // namespace

fs::path find_scene_file(const fs::path& scene)
{
    if (!fs::exists(scene)) {
        throw InputError(
            "there is no scene " + scene.string() +
            "\nhint: name a scene file or its folder, for example examples/dike; quicksand new dike NAME "
            "makes one");
    }
    if (!fs::is_directory(scene)) return scene;
    if (fs::exists(scene / "scene.toml")) return scene / "scene.toml";
    throw InputError("the folder " + scene.string() +
                     " holds no scene.toml\nhint: name the scene file itself");
}

std::vector<SceneReading> read_stages(const SceneChoice& choice, Journal& journal)
{
    start_threads(choice.threads > 0 ? choice.threads : thread_count(), journal);
    return read_scene_stages(find_scene_file(choice.scene), choice.overrides);
}

SceneHashes hashes_of(const SceneChoice& choice, const SceneReading& reading)
{
    // later stages may ask for histories, which no key of this one tells; soil that settles keeps none
    const std::vector<SceneMaterial>& materials = reading.scene.materials;
    const bool remembers = !reading.scene.stage || !settles(reading.scene.stage->kind);
    const bool has_histories =
        remembers && std::any_of(materials.begin(), materials.end(),
                                 [](const SceneMaterial& each) { return keeps_history(each.material.law); });
    return {scene_hash(reading.scene.text, choice.overrides),
            text_hash(state_text(reading.keys) + (has_histories ? "histories" : ""))};
}

SceneSetup set_up_reading(const SceneChoice& choice, SceneReading reading, Journal& journal)
{
    SceneSetup setup;
    setup.keys = reading.keys;
    setup.hashes = hashes_of(choice, reading);
    const double end_time = reading.scene.end_time;
    if (choice.until) reading.scene.end_time = std::max(end_time, *choice.until); // steps of the whole run
    setup.assembled = assemble_case(std::move(reading));
    Scene& scene = setup.assembled.scene;
    scene.end_time = choice.until.value_or(end_time);
    if (scene.stage && settles(scene.stage->kind)) scene.end_time = 0.0; // one frame, settled
    const Diagnostics& warnings = setup.assembled.warnings;
    if (!warnings.empty()) journal.complain(warnings.render(setup.assembled.scene.text));
    return setup;
}

SceneSetup set_up_scene(const SceneChoice& choice, Journal& journal)
{
    return set_up_reading(choice, std::move(read_stages(choice, journal).front()), journal);
}

RunControls run_controls(const Scene& scene)
{
    return {scene.end_time, scene.columns, scene.output.history_interval > 0.0};
}

std::vector<std::string> on_cells_of(double cell_size, const BackgroundGrid& grid)
{
    const auto cells = [&](int count) {
        return static_cast<int>(std::ceil(count * grid.cell_size / cell_size - 1e-9));
    };
    return {fmt::format("grid.cell_size={:.15g}", cell_size),
            fmt::format("grid.cells=[{},{}]", cells(grid.cells_x), cells(grid.cells_y))};
}

std::string scene_name(const fs::path& scene_file)
{
    const fs::path file = fs::absolute(scene_file).lexically_normal();
    return file.filename() == "scene.toml" ? file.parent_path().filename().string() : file.stem().string();
}

fs::path default_results(const fs::path& scene_file)
{
    const fs::path file = fs::absolute(scene_file).lexically_normal();
    const std::string folder = file.parent_path().filename().string();
    return fs::path("results") / (file.filename() == "scene.toml" || folder.empty()
                                      ? scene_name(file)
                                      : folder + "-" + scene_name(file));
}

fs::path report_folder(const fs::path& chosen, const fs::path& scene_file, const std::string& command)
{
    if (!chosen.empty()) return chosen;
    fs::path folder = default_results(scene_file);
    folder += "-" + command;
    return folder;
}

} // namespace quicksand
