#include "app/bench/bench_runs.hpp"

#include "app/run/journal.hpp"

#include <algorithm>
#include <chrono>

namespace quicksand {

std::string file_name_of(std::string name)
{
    std::erase(name, ',');
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

SettingRun run_setting(const std::string& scene, const Setting& setting, const BenchChoice& choice,
                       const std::filesystem::path& directory)
{
    RunChoice run;
    run.scene.scene = scene;
    run.scene.overrides = choice.overrides;
    run.scene.overrides.insert(run.scene.overrides.end(), setting.overrides.begin(), setting.overrides.end());
    run.scene.until = choice.until;
    run.scene.threads = choice.threads;
    run.directory = directory;
    run.overwrite = true;
    const auto start = std::chrono::steady_clock::now();
    Journal journal;
    const SessionEnd end = run_session(run, set_up_scene(run.scene, journal), journal).end;
    return {end, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

} // namespace quicksand
