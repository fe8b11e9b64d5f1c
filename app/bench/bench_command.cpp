#include "app/bench/benchmarks.hpp"
#include "app/bench/law_benchmark.hpp"
#include "app/machine/machine.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/step_cost.hpp"

#include <fmt/format.h>

#include <numeric>

namespace quicksand {

namespace {

std::string table_row(const std::string& name, const std::vector<double>& seconds, double particles)
{
    std::string row = fmt::format("{:<16}", name);
    for (const double time : seconds) {
        row += fmt::format("{:>10.3f}{:>10.1f}{:>18}", 1e3 * time, 1e9 * time / particles,
                           time > 0.0 ? short_number(particles / time, 3) : "-");
    }
    return row + '\n';
}

std::string cost_table(const std::vector<int>& threads, const std::vector<StepCost>& costs, double particles)
{
    std::string table = fmt::format("{:<16}", "threads");
    for (const int count : threads) table += fmt::format("{:>38}", count);
    table += fmt::format("\n{:<16}", "phase");
    for (std::size_t k = 0; k < threads.size(); ++k)
        table += fmt::format("{:>10}{:>10}{:>18}", "ms/step", "ns each", "particle-steps/s");
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

/// Of the phases of a step on one thread, as far as the machine counts.
std::string instruction_table(const StepCost& cost, double particles)
{
    const auto& phases = cost.phases.instructions;
    const double total = std::accumulate(phases.begin(), phases.end(), 0.0);
    if (total == 0.0) {
        return "instructions: not counted, this machine has no counter for them or keeps it from us "
               "(perf_event_paranoid); valgrind\ncounts them, see CONTRIBUTING.md\n";
    }
    std::string table = "instructions each, 1 thread\n";
    for (std::size_t phase = 0; phase < phase_count; ++phase)
        table +=
            fmt::format("{:<16}{:>10.0f}\n", name_of(static_cast<Phase>(phase)), phases[phase] / particles);
    return table + fmt::format("{:<16}{:>10.0f}\n", "whole step", total / particles);
}

void measure_scheme(const BenchChoice& choice, const std::string& scheme, Journal& journal)
{
    std::vector<std::string> overrides;
    if (!scheme.empty()) overrides.push_back("analysis.scheme=\"" + scheme + '"');
    const SceneSetup setup = set_up_body(choice, only_scene(choice), overrides, journal);
    const std::vector<int> counts =
        choice.threads > 0 ? std::vector<int>{choice.threads} : std::vector<int>{1, 2};
    const std::size_t particles = setup.assembled.state.particles.size();
    journal.say(fmt::format("{}{}, {} particles: median of {} runs of {} steps", setup.assembled.scene.title,
                            scheme.empty() ? "" : ", " + scheme + " steps",
                            grouped(static_cast<long long>(particles)), measured_runs,
                            steps_of_a_run(particles)));
    std::vector<StepCost> costs;
    for (const int count : counts) {
        State state = setup.assembled.state; // every count sees the same motion
        costs.push_back(measure_step(setup.assembled.problem, count, state));
    }
    journal.say(cost_table(counts, costs, static_cast<double>(particles)));
    if (counts.front() == 1) journal.say(instruction_table(costs.front(), static_cast<double>(particles)));
}

} // namespace

ExitCode measure_kernel(const BenchChoice& choice)
{
    Journal journal;
    journal.say(machine_text() + '\n');
    if (choice.words.empty()) {
        for (const char* scheme : {"explicit", "semi_implicit"}) measure_scheme(choice, scheme, journal);
    } else {
        measure_scheme(choice, "", journal);
    }
    journal.say(describe_law_cost());
    return ExitCode::good;
}

} // namespace quicksand
