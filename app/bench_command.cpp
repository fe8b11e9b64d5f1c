#include "app/commands.hpp"
#include "app/example_folder.hpp"
#include "app/journal.hpp"
#include "app/law_benchmark.hpp"
#include "app/number_format.hpp"
#include "app/scene_setup.hpp"
#include "solver/simulation.hpp"
#include "solver/two_phase_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>

namespace quicksand {

namespace {

constexpr int warm_up_steps = 20;
constexpr int steps_of_a_run = 150;
constexpr std::size_t runs = 5;

/// Wall time of a step and of its phases [s].
struct StepCost {
    double total = 0.0;
    PhaseTimers phases;
};

void advance(const Problem& problem, double dt, int steps, State& state, TwoPhaseWorkspace& work)
{
    for (int step = 0; step < steps; ++step) advance_two_phase_step(problem, dt, state, work);
}

StepCost measure_run(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work)
{
    work.timers = {};
    const auto start = std::chrono::steady_clock::now();
    advance(problem, dt, steps_of_a_run, state, work);
    StepCost cost;
    cost.total =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps_of_a_run;
    cost.phases = work.timers;
    for (double& seconds : cost.phases.seconds) seconds /= steps_of_a_run;
    return cost;
}

/// The run of median total among five.
StepCost median_cost(const Problem& problem, State state, int threads)
{
    set_thread_count(threads);
    TwoPhaseWorkspace work = make_two_phase_workspace(problem);
    const double dt = stable_time_step(problem, state.particles).dt;
    advance(problem, dt, warm_up_steps, state, work);
    std::array<StepCost, runs> costs;
    for (StepCost& cost : costs) cost = measure_run(problem, dt, state, work);
    std::nth_element(costs.begin(), costs.begin() + runs / 2, costs.end(),
                     [](const StepCost& a, const StepCost& b) { return a.total < b.total; });
    return costs[runs / 2];
}

std::string table_row(const std::string& name, const std::vector<double>& seconds, double particles)
{
    std::string row = fmt::format("{:<16}", name);
    for (const double time : seconds) {
        row +=
            fmt::format("{:>12.3f}{:>22}", 1e3 * time, time > 0.0 ? short_number(particles / time, 3) : "-");
    }
    return row + '\n';
}

std::string cost_table(const std::vector<int>& threads, const std::vector<StepCost>& costs, double particles)
{
    std::string table = fmt::format("{:<16}", "threads");
    for (const int count : threads) table += fmt::format("{:>34}", count);
    table += fmt::format("\n{:<16}", "phase");
    for (std::size_t k = 0; k < threads.size(); ++k)
        table += fmt::format("{:>12}{:>22}", "ms/step", "particle-steps/s");
    table += '\n';
    const auto row = [&](const std::string& name, auto&& seconds_of) {
        std::vector<double> seconds;
        for (const StepCost& cost : costs) seconds.push_back(seconds_of(cost));
        table += table_row(name, seconds, particles);
    };
    for (std::size_t phase = 0; phase < phase_count; ++phase) {
        row(name_of(static_cast<Phase>(phase)),
            [&](const StepCost& cost) { return cost.phases.seconds[phase]; });
    }
    row("whole step", [](const StepCost& cost) { return cost.total; });
    return table;
}

} // namespace

ExitCode measure_kernel(int threads)
{
    Journal journal;
    SceneChoice choice;
    choice.scene = example_folder("dike");
    SceneSetup setup = set_up_scene(choice, journal);
    begin_shaking(setup.assembled.problem, setup.assembled.state);
    const std::vector<int> counts = threads > 0 ? std::vector<int>{threads} : std::vector<int>{1, 2};
    const std::size_t particles = setup.assembled.state.particles.size();
    journal.say(fmt::format("Two-phase step of the dike example, {} particles: median of {} runs of {} steps",
                            grouped(static_cast<long long>(particles)), runs, steps_of_a_run));
    std::vector<StepCost> costs;
    for (const int count : counts)
        costs.push_back(median_cost(setup.assembled.problem, setup.assembled.state, count));
    journal.say(cost_table(counts, costs, static_cast<double>(particles)));
    journal.say(describe_law_cost());
    return ExitCode::good;
}

} // namespace quicksand
