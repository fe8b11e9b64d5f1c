#include "app/run/step_cost.hpp"

#include "app/machine/instruction_counter.hpp"
#include "app/machine/machine.hpp"
#include "app/run/example_folder.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"
#include "solver/free_field/free_field_steps.hpp"
#include "solver/run/held_reactions.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/stepper.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace quicksand {

namespace {

/// The counter's thread takes all steps; none: instructions are not counted.
StepCost measure_run(const Problem& problem, double dt, int steps, const InstructionCounter* counter,
                     State& state, FreeFieldSteps& columns, Stepper& stepper)
{
    stepper.timers() = {};
    if (counter) stepper.timers().executed_instructions = [counter] { return counter->count(); };
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step) {
        timed(stepper.timers(), Phase::free_field, [&] { columns.advance(problem, dt, state); });
        stepper.advance(problem, dt, state);
    }
    StepCost cost;
    cost.time_step = dt;
    cost.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
    cost.phases = stepper.timers();
    cost.phases.executed_instructions = {};
    for (double& seconds : cost.phases.seconds) seconds /= steps;
    for (double& instructions : cost.phases.instructions) instructions /= steps;
    return cost;
}

} // namespace

SceneSetup set_up_body(const BenchChoice& choice, const std::filesystem::path& scene,
                       const std::vector<std::string>& overrides, Journal& journal)
{
    SceneChoice words;
    words.scene = scene;
    words.overrides = choice.overrides;
    words.overrides.insert(words.overrides.end(), overrides.begin(), overrides.end());
    SceneSetup setup = set_up_scene(words, journal);
    begin_shaking(setup.assembled.problem, setup.assembled.state);
    hold_reactions(setup.assembled.problem, setup.assembled.state);
    return setup;
}

std::filesystem::path only_scene(const BenchChoice& choice)
{
    if (choice.words.size() > 1) {
        throw InputError("error[command-line]: bench kernel, grid and scale measure one scene, " +
                         std::to_string(choice.words.size()) +
                         " are given\nexpected: a scene, or none for examples/dike" +
                         "\nhint: bench skip compares several scenes");
    }
    return choice.words.empty() ? example_folder("dike") : std::filesystem::path(choice.words.front());
}

int steps_of_a_run(std::size_t particles)
{
    constexpr double particle_steps = 2e6;
    return static_cast<int>(std::clamp(particle_steps / static_cast<double>(particles), 3.0, 500.0));
}

StepCost measure_step(const Problem& problem, int threads, State& state)
{
    set_thread_count(threads);
    const std::unique_ptr<Stepper> stepper = make_stepper(problem);
    FreeFieldSteps columns(problem);
    measure_bounds(problem, state);
    const double dt = shortest_time_step(problem, state).dt;
    note_whole_step(dt, state);
    const int steps = steps_of_a_run(state.particles.size());
    const InstructionCounter counter;
    const InstructionCounter* const counting = threads == 1 && counter.works() ? &counter : nullptr;
    measure_run(problem, dt, std::max(2, steps / 5), counting, state, columns, *stepper);
    std::array<StepCost, measured_runs> costs;
    for (StepCost& cost : costs) cost = measure_run(problem, dt, steps, counting, state, columns, *stepper);
    const double resident = resident_bytes();
    std::nth_element(costs.begin(), costs.begin() + measured_runs / 2, costs.end(),
                     [](const StepCost& a, const StepCost& b) { return a.total < b.total; });
    costs[measured_runs / 2].resident = resident;
    return costs[measured_runs / 2];
}

} // namespace quicksand
