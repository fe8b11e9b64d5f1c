#include "io/sweeps/sweep_runs.hpp"

#include "io/scene/scene_file.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

/// The values of a random key as TOML writes them; ten digits, so that the last bit of a library's logarithm
/// makes no other run.
std::vector<std::string> draw_texts(const VariedKey& key, const Sweep& sweep)
{
    std::vector<std::string> texts;
    for (const double value : draw_values(*key.distribution, sweep.seed, key.key, sweep.samples)) {
        const std::string number = fmt::format("{:.10g}", value);
        const std::string& unit = key.distribution->unit;
        texts.push_back(unit.empty() ? number : toml_text(number + " " + unit));
    }
    return texts;
}

RunValue value_of(const std::string& key, const std::vector<ResolvedKey>& keys)
{
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const ResolvedKey& each) { return each.path == key; });
    if (found == keys.end()) return {"", "", std::numeric_limits<double>::quiet_NaN()};
    RunValue value{found->value, found->unit, 0.0};
    const char* const end = value.text.data() + value.text.size();
    const auto [last, error] = std::from_chars(value.text.data(), end, value.number);
    if (error != std::errc() || last != end) value.number = std::numeric_limits<double>::quiet_NaN();
    return value;
}

/// The last stage that shakes, or else the last one that is no search: as with_histories() has it.
const SceneReading& collected(const std::vector<SceneReading>& stages)
{
    const auto last = [&](auto&& suits) {
        return std::find_if(stages.rbegin(), stages.rend(), [&](const SceneReading& reading) {
            return reading.scene.stage && suits(reading.scene.stage->kind);
        });
    };
    auto found = last([](StageKind kind) { return kind == StageKind::shake; });
    if (found == stages.rend()) found = last([](StageKind kind) { return kind != StageKind::stability; });
    if (found != stages.rend()) return *found;
    return stages.back();
}

CheckedRun check_run(const Sweep& sweep, SweepRun run)
{
    const std::vector<SceneReading> stages = read_scene_stages(sweep.scene, run.overrides);
    const SceneReading& reading = collected(stages);
    CheckedRun checked;
    checked.results = run.folder;
    if (reading.scene.stage) checked.results += "/" + reading.scene.stage->name;
    for (const VariedKey& key : sweep.varied) checked.values.push_back(value_of(key.key, reading.keys));
    checked.hash = scene_hash(reading.scene.text, run.overrides);
    for (const SceneProbe& probe : reading.scene.probes)
        if (!probe.to) checked.probes.push_back(probe.name);
    checked.inputs = input_files(reading.scene, reading.keys);
    checked.run = std::move(run);
    return checked;
}

/// A message and the runs that it is said of.
struct RunError {
    std::string message;
    std::vector<int> runs;
};

void add_error(std::vector<RunError>& errors, const std::string& message, int run)
{
    for (RunError& error : errors) {
        if (error.message != message) continue;
        error.runs.push_back(run);
        return;
    }
    errors.push_back({message, {run}});
}

std::string runs_text(const std::vector<int>& runs)
{
    constexpr std::size_t shown = 8;
    std::string text;
    for (std::size_t k = 0; k < std::min(shown, runs.size()); ++k)
        text += (text.empty() ? "" : ", ") + std::to_string(runs[k]);
    if (runs.size() > shown) text += fmt::format(" and {} more", runs.size() - shown);
    return (runs.size() == 1 ? "run " : "runs ") + text;
}

[[noreturn]] void refuse_runs(const Sweep& sweep, const std::vector<RunError>& errors)
{
    constexpr std::size_t shown = 20;
    std::string text;
    for (std::size_t k = 0; k < std::min(shown, errors.size()); ++k)
        text += fmt::format("{}{}: {} cannot be run:\n{}", text.empty() ? "" : "\n\n", sweep.file.string(),
                            runs_text(errors[k].runs), errors[k].message);
    if (errors.size() > shown) text += fmt::format("\n\nand {} more", errors.size() - shown);
    throw InputError(text);
}

} // namespace

std::vector<SweepRun> runs_of(const Sweep& sweep)
{
    std::vector<std::vector<std::string>> drawn; // by varied key; none of a list
    std::size_t count = 1;
    const bool random = std::any_of(sweep.varied.begin(), sweep.varied.end(),
                                    [](const VariedKey& key) { return key.distribution.has_value(); });
    const std::size_t samples = random ? static_cast<std::size_t>(sweep.samples) : 1;
    for (const VariedKey& key : sweep.varied) {
        drawn.push_back(key.distribution ? draw_texts(key, sweep) : std::vector<std::string>());
        if (!key.distribution) count *= key.values.size();
    }
    std::vector<SweepRun> runs;
    for (std::size_t k = 0; k < count * samples; ++k) {
        SweepRun run{static_cast<int>(k) + 1, fmt::format("run_{:04}", k + 1), sweep.fixed};
        std::size_t rest = k / samples, stride = count;
        for (std::size_t v = 0; v < sweep.varied.size(); ++v) {
            const VariedKey& key = sweep.varied[v];
            if (key.distribution) {
                run.overrides.push_back(key.key + "=" + drawn[v][k % samples]);
                continue;
            }
            stride /= key.values.size();
            run.overrides.push_back(key.key + "=" + key.values[rest / stride]);
            rest %= stride;
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

std::vector<CheckedRun> check_runs(const Sweep& sweep)
{
    std::vector<CheckedRun> checked;
    std::vector<RunError> errors;
    for (SweepRun& run : runs_of(sweep)) {
        const int number = run.number;
        try {
            checked.push_back(check_run(sweep, std::move(run)));
        } catch (const InputError& error) {
            add_error(errors, error.what(), number);
        }
    }
    if (!errors.empty()) refuse_runs(sweep, errors);
    return checked;
}

} // namespace quicksand
