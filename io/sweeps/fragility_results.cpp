#include "io/sweeps/fragility_results.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/pictures/picture_probes.hpp"
#include "io/sweeps/sweep_figures.hpp"
#include "solver/base/conventions.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace quicksand {

namespace {

/// `whose` has none: "no finished run has".
[[noreturn]] void refuse_quantity(const Sweep& sweep, const std::string& whose,
                                  const std::vector<std::string>& known)
{
    const std::string nearest = nearest_name(sweep.fragility->quantity, known);
    throw InputError(sweep.file.string() + ": " + whose + " fragility.quantity = \"" +
                     sweep.fragility->quantity + "\"" +
                     (known.empty() ? "" : "\nexpected: " + one_of(known)) +
                     (nearest.empty() ? "" : "\nhint: did you mean \"" + nearest + "\"?"));
}

void add_columns(const std::vector<PanelPlan>& plans, const std::string& table,
                 std::vector<std::string>& names)
{
    for (const PanelPlan& plan : plans)
        for (const PanelColumn& column : plan.columns) names.push_back(table + column.column);
}

/// Columns of sweep.csv that a run may have, without _peak and _final.
std::vector<std::string> quantities_to_come(const std::vector<CheckedRun>& runs)
{
    std::vector<std::string> names(summarized_extremes.begin(), summarized_extremes.end());
    add_columns(history_plan(), "", names);
    std::set<std::string> probes;
    for (const CheckedRun& run : runs) probes.insert(run.probes.begin(), run.probes.end());
    for (const std::string& probe : probes) add_columns(probe_plan(), probe + '.', names);
    return names;
}

std::size_t intensity_of(const Sweep& sweep)
{
    const auto found = std::find_if(sweep.varied.begin(), sweep.varied.end(), [&](const VariedKey& key) {
        return key.key == sweep.fragility->intensity;
    });
    ENSURE(found != sweep.varied.end());
    return static_cast<std::size_t>(found - sweep.varied.begin());
}

std::string shown_intensity(const FragilityResults& results, double intensity)
{
    if (results.unit == "m/s2") return fmt::format("{:.4g} g", intensity / standard_gravity);
    return fmt::format("{:.4g}{}{}", intensity, results.unit.empty() ? "" : " ", results.unit);
}

} // namespace

void require_quantity(const Sweep& sweep, const std::vector<CheckedRun>& runs)
{
    if (!sweep.fragility) return;
    const std::vector<std::string> known = quantities_to_come(runs);
    const std::string& quantity = sweep.fragility->quantity;
    const bool found = std::any_of(known.begin(), known.end(), [&](const std::string& name) {
        return quantity == name || quantity == name + "_peak" || quantity == name + "_final";
    });
    if (!found) refuse_quantity(sweep, "no run will have", known);
}

void require_intensities(const Sweep& sweep, const std::vector<CheckedRun>& runs)
{
    if (!sweep.fragility) return;
    const std::size_t varied = intensity_of(sweep);
    for (const CheckedRun& run : runs)
        if (!(run.values[varied].number > 0.0))
            throw InputError(sweep.file.string() + ": " + sweep.fragility->intensity +
                             " is no intensity of a fragility curve in run " +
                             std::to_string(run.run.number) + "\nexpected: numbers above 0");
}

FragilityResults assess_fragility(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes)
{
    FragilityResults results;
    results.varied = intensity_of(sweep);
    results.unit = outcomes.front().checked.values[results.varied].unit;
    std::map<double, FragilityLevel> levels;
    std::vector<FragilityPoint> points;
    for (const SweepOutcome& outcome : outcomes) {
        const double intensity = outcome.checked.values[results.varied].number;
        const double value = std::abs(value_of(outcome, sweep.fragility->quantity));
        if (outcome.state != "finished" || std::isnan(value)) {
            ++results.left_out;
            continue;
        }
        const bool exceeds = value > sweep.fragility->threshold;
        points.push_back({intensity, exceeds});
        FragilityLevel& level = levels[intensity];
        level.intensity = intensity;
        ++level.runs;
        level.exceeding += exceeds ? 1 : 0;
    }
    if (points.empty()) refuse_quantity(sweep, "no finished run has", quantities_of(outcomes));
    for (const auto& [intensity, level] : levels) results.levels.push_back(level);
    results.fit = fit_fragility(points);
    return results;
}

std::string describe_fragility(const FragilityResults& results)
{
    std::string left_out;
    if (results.left_out > 0)
        left_out =
            fmt::format("; {} left out: not finished, or without a value",
                        results.left_out == 1 ? "1 run is" : fmt::format("{} runs are", results.left_out));
    if (!results.fit.curve) return "no curve, for " + results.fit.why_not + left_out;
    return fmt::format("median {}, beta {:.3g}{}", shown_intensity(results, results.fit.curve->median),
                       results.fit.curve->beta, left_out);
}

void write_fragility_csv(const std::filesystem::path& path, const Sweep& sweep,
                         const FragilityResults& results)
{
    const FragilityRequest& request = *sweep.fragility;
    std::vector<std::string> comments{
        "Quicksand " + program_version(),
        fmt::format("{} above {:g}, over {}", request.quantity, request.threshold, request.intensity)};
    if (results.fit.curve)
        comments.push_back(
            fmt::format("lognormal curve of maximum likelihood: median {:.6g}{}{}, beta {:.6g}",
                        results.fit.curve->median, results.unit.empty() ? "" : " ", results.unit,
                        results.fit.curve->beta));
    else
        comments.push_back("no curve: " + results.fit.why_not);
    std::string text = csv_header(comments, {column_of(sweep.varied[results.varied], {"", results.unit}),
                                             "runs", "exceeding", "share", "probability"});
    for (const FragilityLevel& level : results.levels)
        text += fmt::format(
            "{},{},{},{},{}\n", csv_number(level.intensity), level.runs, level.exceeding,
            csv_number(level.share()),
            csv_number(results.fit.curve ? results.fit.curve->probability(level.intensity) : std::nan("")));
    write_atomically(path, text);
}

LinePlot fragility_plot(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes,
                        const FragilityResults& results)
{
    constexpr int pieces = 200;
    const KeyAxis axis = axis_of(sweep, results.varied, outcomes);
    const double end = 1.05 * results.levels.back().intensity;
    PlotPanel panel{axis.label, "Probability", {}, KeyPlace::lower_right};
    if (results.fit.curve) {
        PlotCurve curve{"lognormal curve", curve_colour(0, 1), {0.0}, {0.0}};
        for (int k = 1; k <= pieces; ++k) {
            const double intensity = end * k / pieces;
            curve.x.push_back(intensity / axis.factor);
            curve.y.push_back(results.fit.curve->probability(intensity));
        }
        panel.curves.push_back(std::move(curve));
    }
    PlotCurve shares{"share of the runs", curve_colour(1, 2), {}, {}, CurveStyle::points};
    for (const FragilityLevel& level : results.levels) {
        shares.x.push_back(level.intensity / axis.factor);
        shares.y.push_back(level.share());
    }
    panel.curves.push_back(std::move(shares));
    panel.y_range = PlotRange{-0.04, 1.04}; // points at 0 and 1 are seen whole
    const FragilityRequest& request = *sweep.fragility;
    return {
        sweep.title.empty() ? sweep.file.stem().string() : sweep.title,
        fmt::format("{} above {:g}: {}", request.quantity, request.threshold, describe_fragility(results)),
        {std::move(panel)},
        PlotArrangement::stacked};
}

} // namespace quicksand
