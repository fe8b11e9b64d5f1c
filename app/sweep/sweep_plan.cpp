#include "app/sweep/sweep_plan.hpp"

#include "app/run/number_format.hpp"
#include "app/stages/run_origin.hpp"
#include "io/results/results_folder.hpp"
#include "io/sweeps/fragility_results.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

fs::path find_sweep_file(const fs::path& word)
{
    if (!fs::exists(word))
        throw InputError("there is no sweep " + word.string() +
                         "\nhint: name the sweep's file, for example examples/sweep/sweep.toml");
    if (!fs::is_directory(word)) return word;
    if (fs::exists(word / "sweep.toml")) return word / "sweep.toml";
    throw InputError("the folder " + word.string() +
                     " holds no sweep.toml\nhint: name the sweep's file itself");
}

/// results/NAME of the file; of a sweep.toml, of its folder.
fs::path default_folder(const fs::path& file)
{
    const fs::path whole = fs::absolute(file).lexically_normal();
    return fs::path("results") /
           (whole.filename() == "sweep.toml" ? whole.parent_path().filename() : whole.stem());
}

/// A run's folder is gone on with, or left alone.
void refuse_other_results(const SweepPlan& plan, const std::vector<SweepOutcome>& outcomes)
{
    const auto other = std::find_if(outcomes.begin(), outcomes.end(),
                                    [](const SweepOutcome& outcome) { return outcome.state == "other"; });
    if (other != outcomes.end())
        throw InputError((plan.folder / other->checked.run.folder).string() +
                         " holds the results of another run: the scene or the sweep has changed since\nhint: "
                         "choose another "
                         "folder with -o, or remove this one");
    for (const SweepOutcome& outcome : outcomes)
        if (outcome.state != "missing")
            require_same_inputs(ResultsFolder{plan.folder / outcome.checked.results}.manifest(),
                                outcome.checked.inputs);
}

std::string value_text_of(const std::string& key, const RunValue& value)
{
    const std::string number = std::isnan(value.number) ? value.text : short_number(value.number, 6);
    return key + " = " + number + (value.unit.empty() ? "" : " " + value.unit);
}

} // namespace

SweepPlan plan_sweep(const SweepChoice& choice)
{
    SweepPlan plan;
    plan.sweep = read_sweep_file(find_sweep_file(choice.file));
    plan.runs = check_runs(plan.sweep);
    require_quantity(plan.sweep, plan.runs);
    require_intensities(plan.sweep, plan.runs);
    plan.folder = fs::absolute(choice.directory.empty() ? default_folder(plan.sweep.file) : choice.directory)
                      .lexically_normal();
    if (!choice.from.empty())
        plan.from = fs::absolute(folder_of_end(choice.from)).lexically_normal().string();
    plan.jobs = choice.jobs;
    const bool here = choice.engine == "local" || choice.engine == "parallel";
    plan.threads = choice.threads > 0 ? choice.threads
                   : here             ? std::max(1, processor_count() / choice.jobs)
                                      : 1;
    const std::vector<SweepOutcome> outcomes = read_outcomes(plan.runs, plan.folder);
    refuse_other_results(plan, outcomes);
    for (std::size_t k = 0; k < outcomes.size(); ++k)
        if (outcomes[k].state != "finished") plan.left.push_back(k);
    return plan;
}

std::vector<std::string> words_of(const SweepPlan& plan, const CheckedRun& run)
{
    std::vector<std::string> words{"run", fs::absolute(plan.sweep.scene).lexically_normal().string()};
    for (const std::string& word : run.run.overrides) words.insert(words.end(), {"--set", word});
    words.insert(words.end(), {"-o", (plan.folder / run.run.folder).string(), "--threads",
                               std::to_string(plan.threads), "--continue"});
    if (!plan.from.empty()) words.insert(words.end(), {"--from", plan.from});
    return words;
}

fs::path drawings_of(const SweepPlan& plan)
{
    return plan.folder / "drawings";
}

std::string describe_plan(const SweepPlan& plan)
{
    std::string text = fmt::format("{} runs of {}; {} left to do", plan.runs.size(),
                                   plan.sweep.scene.string(), plan.left.size());
    for (std::size_t k = 0; k < plan.runs.size(); ++k) {
        const CheckedRun& run = plan.runs[k];
        text += "\n  " + run.run.folder;
        for (std::size_t v = 0; v < run.values.size(); ++v)
            text += "  " + value_text_of(plan.sweep.varied[v].key, run.values[v]);
        const bool left = std::find(plan.left.begin(), plan.left.end(), k) != plan.left.end();
        const bool begun = fs::exists(ResultsFolder{plan.folder / run.results}.checkpoint());
        text += !left ? "  finished" : begun ? "  goes on" : "";
    }
    return text;
}

} // namespace quicksand
