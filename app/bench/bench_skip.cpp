#include "app/bench/benchmarks.hpp"
#include "app/machine/machine.hpp"
#include "app/run/example_folder.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/step_cost.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "solver/columns/soil_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

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
    scenes.push_back(example_folder("shake_table"));
    return scenes;
}

SkipPoint measure_body(const std::string& name, std::size_t particles, const Problem& problem, State& state,
                       int threads)
{
    return {name, particles, measure_step(problem, threads, state),
            static_cast<double>(memory_bytes(state.particles))};
}

/// The scene, and the one column of it that a run computes, if there is one; all per particle of the body.
std::vector<SkipPoint> measure_skipping(const BenchChoice& choice, const fs::path& scene, Journal& journal)
{
    SceneSetup setup = set_up_body(choice, scene, {}, journal);
    AssembledCase& body = setup.assembled;
    const std::size_t particles = body.state.particles.size();
    const int threads = std::max(1, choice.threads);
    auto column = find_soil_column(body.problem, body.state).column; // before the body moves
    std::vector<SkipPoint> points{
        measure_body(body.scene.title, particles, body.problem, body.state, threads)};
    if (column) {
        points.push_back(measure_body(fmt::format("the same, one of {} columns", column->columns), particles,
                                      column->problem, column->state, threads));
    }
    return points;
}

/// Wall time of a particle's step [s].
double each(const SkipPoint& point)
{
    return point.cost.total / static_cast<double>(point.particles);
}

/// Wall time of a particle's second of motion [s].
double each_second(const SkipPoint& point)
{
    return each(point) / point.cost.time_step;
}

std::string skip_row(const SkipPoint& point, const SkipPoint& first)
{
    return fmt::format("{:<36}{:>12}{:>10.1f}{:>8.0f} %{:>12.3g}{:>12.0f} %{:>16.0f}",
                       point.name.substr(0, 35), grouped(static_cast<long long>(point.particles)),
                       1e9 * each(point), 100.0 * each(point) / each(first), point.cost.time_step,
                       100.0 * each_second(point) / each_second(first),
                       point.bytes / static_cast<double>(point.particles));
}

} // namespace

ExitCode measure_skips(const BenchChoice& choice)
{
    Journal journal;
    fs::create_directories(choice.directory);
    journal.say(machine_text());
    journal.say(fmt::format("{:<36}{:>12}{:>10}{:>10}{:>12}{:>14}{:>16}", "scene; relative to the first",
                            "particles", "ns each", "a step", "dt s", "a second", "bytes/particle"));
    std::string csv = "# " + machine_text() + "\nscene,particles,step_s,time_step_s,bytes\n";
    std::optional<SkipPoint> first;
    for (const fs::path& scene : scenes_of(choice)) {
        for (const SkipPoint& point : measure_skipping(choice, scene, journal)) {
            if (!first) first = point;
            journal.say(skip_row(point, *first));
            csv += fmt::format("{},{},{:.6g},{:.6g},{:.0f}\n", csv_text(point.name), point.particles,
                               point.cost.total, point.cost.time_step, point.bytes);
        }
    }
    write_atomically(choice.directory / "skip.csv", csv);
    journal.say("The table is in " + (choice.directory / "skip.csv").string());
    return ExitCode::good;
}

} // namespace quicksand
