#include "app/bench/benchmarks.hpp"
#include "app/machine/machine.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/step_cost.hpp"
#include "io/files/atomic_file.hpp"
#include "solver/base/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// One body on a number of threads.
struct ScalePoint {
    std::size_t particles = 0;
    int threads = 0;
    double seconds = 0.0; // of a step
    double bytes = 0.0;   // of the process, by the body
    double cell_size = 0.0;
};

/// 1, 2, 4, ... up to all.
std::vector<int> thread_counts(int most)
{
    std::vector<int> counts;
    for (int count = 1; count < most; count *= 2) counts.push_back(count);
    counts.push_back(most);
    return counts;
}

std::string scale_row(const ScalePoint& point)
{
    const auto particles = static_cast<double>(point.particles);
    return fmt::format("{:>12}{:>9}{:>12.3f}{:>12.1f}{:>20}{:>18.0f}",
                       grouped(static_cast<long long>(point.particles)), point.threads, 1e3 * point.seconds,
                       1e9 * point.seconds / particles, short_number(particles / point.seconds, 3),
                       point.bytes / particles);
}

std::string scale_csv(const std::vector<ScalePoint>& points)
{
    std::string text = "# " + machine_text() + "\nparticles,threads,cell_size_m,step_s,bytes\n";
    for (const ScalePoint& point : points)
        text += fmt::format("{},{},{},{:.6g},{:.0f}\n", point.particles, point.threads, point.cell_size,
                            point.seconds, point.bytes);
    return text;
}

} // namespace

ExitCode measure_scale(const BenchChoice& choice)
{
    Journal journal;
    const std::filesystem::path scene = only_scene(choice);
    std::filesystem::create_directories(choice.directory);
    const int most = choice.threads > 0 ? choice.threads : thread_count();
    const SceneSetup drawn = set_up_body(choice, scene, {}, journal);
    const BackgroundGrid grid = drawn.assembled.problem.grid;
    const auto own = static_cast<double>(drawn.assembled.state.particles.size());
    journal.say(machine_text());
    journal.say(fmt::format("{:>12}{:>9}{:>12}{:>12}{:>20}{:>18}", "particles", "threads", "ms/step",
                            "ns each", "particle-steps/s", "bytes/particle"));
    std::vector<ScalePoint> points;
    for (const double wanted : {1e3, 1e4, 1e5, 3e5, 1e6, 3e6}) {
        if (wanted > choice.largest) break;
        const double cell_size = grid.cell_size * std::sqrt(own / wanted);
        const double before = resident_bytes();
        SceneSetup setup = set_up_body(choice, scene, on_cells_of(cell_size, grid), journal);
        State& state = setup.assembled.state;
        for (const int threads : thread_counts(most)) {
            ScalePoint point{state.particles.size(), threads, 0.0, 0.0, cell_size};
            const StepCost cost = measure_step(setup.assembled.problem, threads, state);
            point.seconds = cost.total;
            point.bytes = std::max(0.0, cost.resident - before);
            points.push_back(point);
            journal.say(scale_row(point));
        }
    }
    write_atomically(choice.directory / "scale.csv", scale_csv(points));
    journal.say("The table is in " + (choice.directory / "scale.csv").string());
    return ExitCode::good;
}

} // namespace quicksand
