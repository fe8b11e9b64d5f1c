#include "app/commands.hpp"
#include "app/example_folder.hpp"
#include "app/journal.hpp"
#include "app/machine.hpp"
#include "app/number_format.hpp"
#include "app/step_cost.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// What one scene costs a particle and step.
struct SkipPoint {
    std::string name;
    std::size_t particles = 0;
    StepCost cost;
    double bytes = 0.0; // of the particles' arrays
};

/// The scenes that come with the program; the first has everything.
std::vector<fs::path> scenes_of(const BenchChoice& choice)
{
    std::vector<fs::path> scenes(choice.words.begin(), choice.words.end());
    if (!scenes.empty()) return scenes;
    for (const char* name : {"scene", "small_strain", "undrained", "elastic", "dry", "dry_elastic"})
        scenes.push_back(example_folder("benchmarks") / (std::string(name) + ".toml"));
    return scenes;
}

SkipPoint measure(const BenchChoice& choice, const fs::path& scene, Journal& journal)
{
    const SceneSetup setup = set_up_body(choice, scene, {}, journal);
    const State& state = setup.assembled.state;
    SkipPoint point;
    point.name = setup.assembled.scene.title;
    point.particles = state.particles.size();
    point.bytes = static_cast<double>(memory_bytes(state.particles));
    point.cost = measure_step(setup.assembled.problem, state, std::max(1, choice.threads));
    return point;
}

double each(const SkipPoint& point)
{
    return point.cost.total / static_cast<double>(point.particles);
}

} // namespace

ExitCode measure_skips(const BenchChoice& choice)
{
    Journal journal;
    fs::create_directories(choice.directory);
    journal.say(machine_text());
    journal.say(fmt::format("{:<36}{:>12}{:>12}{:>14}{:>18}", "scene", "particles", "ns each", "of the first",
                            "bytes/particle"));
    std::string csv = "# " + machine_text() + "\nscene,particles,step_s,bytes\n";
    double first = 0.0;
    for (const fs::path& scene : scenes_of(choice)) {
        const SkipPoint point = measure(choice, scene, journal);
        if (first == 0.0) first = each(point);
        journal.say(fmt::format("{:<36}{:>12}{:>12.1f}{:>12.0f} %{:>18.0f}", point.name,
                                grouped(static_cast<long long>(point.particles)), 1e9 * each(point),
                                100.0 * each(point) / first,
                                point.bytes / static_cast<double>(point.particles)));
        csv += fmt::format("{},{},{:.6g},{:.0f}\n", csv_text(point.name), point.particles, point.cost.total,
                           point.bytes);
    }
    write_atomically(choice.directory / "skip.csv", csv);
    journal.say("The table is in " + (choice.directory / "skip.csv").string());
    return ExitCode::good;
}

} // namespace quicksand
