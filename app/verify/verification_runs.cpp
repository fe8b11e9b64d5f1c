#include "app/verify/verification_runs.hpp"

#include "app/run/example_folder.hpp"
#include "app/run/number_format.hpp"
#include "app/run/scene_setup.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "io/tables/scene_verification.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"
#include "solver/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <map>
#include <mutex>
#include <numeric>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// The scene that a word of the command line means: a path, or a name in examples/verification.
fs::path scene_of(const std::string& word)
{
    if (fs::exists(word)) return find_scene_file(word);
    const std::vector<std::string> names = verification_names();
    if (std::find(names.begin(), names.end(), word) != names.end()) {
        return example_folder("verification/" + word) / "scene.toml";
    }
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    const std::string nearest = nearest_name(word, names);
    throw InputError("there is no problem '" + word + "' to verify\nexpected: " + list +
                     ", or a scene with a table [verification]" +
                     (nearest.empty() ? "" : "\nhint: did you mean " + nearest + "?"));
}

VerificationRun prepare_run(const fs::path& scene, const std::vector<std::string>& given,
                            const SceneVerification& verification, int cells)
{
    std::vector<std::string> overrides = given;
    for (std::string& override : resolution_overrides(verification, cells)) {
        overrides.push_back(std::move(override));
    }
    VerificationRun run;
    run.problem = scene_name(scene);
    run.study = find_study(verification.problem);
    run.verification = verification;
    run.cells = cells;
    const SceneReading file = read_scene_file(scene, overrides);
    run.title = file.scene.title;
    run.assembled = assemble_case(file);
    ENSURE(run.study != nullptr);
    return run;
}

void execute(VerificationRun& run)
{
    const auto start = std::chrono::steady_clock::now();
    try {
        begin_shaking(run.assembled.problem, run.assembled.state);
        run.errors =
            run.study->measure(run.assembled.problem, run.assembled.state, run.verification.parameters);
    } catch (...) {
        run.failure = std::current_exception();
    }
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.assembled = AssembledCase(); // its memory is not needed any more
}

/// The runs by their expected cost: particles times steps, which grow as the cells.
std::vector<std::size_t> largest_first(const std::vector<VerificationRun>& runs)
{
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto cost = [&](const VerificationRun& run) {
            return static_cast<double>(run.assembled.state.particles.size()) * run.cells;
        };
        return cost(runs[a]) > cost(runs[b]);
    });
    return order;
}

/// The scenes that the words mean, each once. Tables and figures call a problem by its name: two must differ.
std::vector<fs::path> scenes_of(const std::vector<std::string>& words)
{
    std::vector<fs::path> scenes;
    std::map<fs::path, fs::path> known; // by the problem's name
    for (const std::string& word : words) {
        const fs::path scene = scene_of(word);
        const auto [same, is_new] = known.emplace(scene_name(scene), scene);
        if (is_new) {
            scenes.push_back(scene);
        } else if (!fs::equivalent(same->second, scene)) {
            throw InputError("two problems are called '" + same->first.string() +
                             "': " + same->second.string() + " and " + scene.string() +
                             "\nhint: verify them one after the other, or rename a folder");
        }
    }
    return scenes;
}

} // namespace

std::vector<VerificationRun> prepare_runs(const VerifyChoice& choice)
{
    std::vector<VerificationRun> runs;
    for (const fs::path& scene :
         scenes_of(choice.problems.empty() ? verification_names() : choice.problems)) {
        const auto verification = read_scene_file(scene, choice.overrides).scene.verification;
        if (!verification) {
            throw InputError(scene.string() + " holds no table [verification]\nhint: quicksand run runs it");
        }
        for (const int cells : choice.shortened ? verification->short_cells : verification->cells) {
            runs.push_back(prepare_run(scene, choice.overrides, *verification, cells));
        }
    }
    return runs;
}

void execute_runs(int threads, std::vector<VerificationRun>& runs, Journal& journal)
{
    const std::vector<std::size_t> order = largest_first(runs);
    std::atomic<std::size_t> next = 0;
    std::mutex speaking;
    const auto work = [&] {
        set_thread_count(1); // of this worker
        for (std::size_t k = next++; k < order.size(); k = next++) {
            VerificationRun& run = runs[order[k]];
            execute(run);
            const std::lock_guard<std::mutex> lock(speaking);
            journal.say(fmt::format("{}, {} cells: {}{}", run.problem, run.cells, duration_text(run.seconds),
                                    run.failure ? ", failed" : ""));
        }
    };
    // Futures and not threads, for they hand on a failure of the journal.
    std::vector<std::future<void>> workers;
    for (int k = 0; k < std::max(1, threads); ++k) workers.push_back(std::async(std::launch::async, work));
    for (std::future<void>& worker : workers) worker.get();
}

} // namespace quicksand
