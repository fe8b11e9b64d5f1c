#include "app/sweep/sweep_collection.hpp"

#include "io/sweeps/fragility_results.hpp"
#include "io/sweeps/sweep_figures.hpp"

#include <fmt/format.h>

#include <map>

namespace quicksand {

namespace {

/// "3 finished (2 good, 1 usable), 1 failed"
std::string count_states(const std::vector<SweepOutcome>& outcomes)
{
    std::map<std::string, int> states;
    std::map<std::string, int> verdicts;
    for (const SweepOutcome& outcome : outcomes) {
        ++states[outcome.state];
        if (outcome.state == "finished") ++verdicts[outcome.verdict];
    }
    std::string text, of_verdicts;
    for (const auto& [verdict, count] : verdicts)
        of_verdicts += fmt::format("{}{} {}", of_verdicts.empty() ? "" : ", ", count, verdict);
    for (const auto& [state, count] : states)
        text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, state,
                            state == "finished" ? " (" + of_verdicts + ")" : "");
    return text;
}

} // namespace

void collect_sweep(const SweepPlan& plan, Journal& journal)
{
    const std::vector<SweepOutcome> outcomes = read_outcomes(plan.runs, plan.folder);
    write_sweep_csv(plan.folder / "sweep.csv", plan.sweep, outcomes);
    journal.say(fmt::format("{} runs: {}", outcomes.size(), count_states(outcomes)));
    std::vector<Drawing> drawings;
    const std::vector<LinePlot> plots = sweep_plots(plan.sweep, outcomes);
    for (std::size_t k = 0; k < plots.size(); ++k)
        drawings.push_back(plot_drawing(
            plots[k],
            plan.folder / (k == 0 ? std::string("sweep.png") : fmt::format("sweep_{}.png", k + 1))));
    if (plan.sweep.fragility && !plots.empty()) {
        const FragilityResults fragility = assess_fragility(plan.sweep, outcomes);
        write_fragility_csv(plan.folder / "fragility.csv", plan.sweep, fragility);
        drawings.push_back(
            plot_drawing(fragility_plot(plan.sweep, outcomes, fragility), plan.folder / "fragility.png"));
        journal.say("Fragility: " + describe_fragility(fragility));
    }
    for (const std::filesystem::path& file : draw_pictures(drawings)) journal.say(file.string());
    journal.say((plan.folder / "sweep.csv").string());
}

} // namespace quicksand
