#include "io/sweeps/sweep_figures.hpp"

#include "solver/base/conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace quicksand {

namespace {

struct DrawnQuantity {
    std::string label;
    std::vector<double> values; // in amount, NaN where a run has none [m]
};

DrawnQuantity drawn_quantity(const std::vector<SweepOutcome>& outcomes)
{
    for (const auto& [name, label] : {std::pair("crest_settlement_m", "Crest settlement"),
                                      std::pair("max_displacement_m", "Largest displacement")}) {
        DrawnQuantity quantity{label, {}};
        for (const SweepOutcome& outcome : outcomes)
            quantity.values.push_back(std::abs(value_of(outcome, name)));
        if (largest_of(quantity.values) >= 0.0) return quantity;
    }
    return {};
}

/// The unit in which the values of a key are shown, and by which they are divided.
DisplayUnit shown_unit(std::size_t varied, const std::vector<SweepOutcome>& outcomes)
{
    const std::string& si = outcomes.front().checked.values[varied].unit;
    if (si == "m/s2") return {standard_gravity, "g"};
    double largest = 0.0;
    for (const SweepOutcome& outcome : outcomes)
        largest = std::max(largest, std::abs(outcome.checked.values[varied].number));
    return display_unit(si, largest);
}

/// What tells a run's curve from others: the values of the other listed keys.
std::string curve_name(const Sweep& sweep, std::size_t varied, std::size_t run,
                       const std::vector<SweepOutcome>& outcomes)
{
    std::string name;
    for (std::size_t v = 0; v < sweep.varied.size(); ++v) {
        if (v == varied) continue;
        const RunValue& value = outcomes[run].checked.values[v];
        const std::string& key = sweep.varied[v].key;
        name += (name.empty() ? "" : ", ") + key.substr(key.rfind('.') + 1) + " ";
        if (std::isnan(value.number)) {
            name += value.text;
            continue;
        }
        const DisplayUnit unit = shown_unit(v, outcomes);
        name +=
            fmt::format("{:.4g}{}{}", value.number / unit.factor, unit.text.empty() ? "" : " ", unit.text);
    }
    return name;
}

bool is_grid(const Sweep& sweep)
{
    return std::none_of(sweep.varied.begin(), sweep.varied.end(),
                        [](const VariedKey& key) { return key.distribution.has_value(); });
}

std::vector<PlotCurve> one_cloud(const KeyAxis& axis, const std::vector<double>& values)
{
    return {{"", curve_colour(0, 1), axis.values, values, CurveStyle::points}};
}

/// A curve for each combination of the other keys where these are few, else points.
std::vector<PlotCurve> curves_of(const Sweep& sweep, std::size_t varied, const KeyAxis& axis,
                                 const std::vector<double>& values, const std::vector<SweepOutcome>& outcomes)
{
    constexpr std::size_t most_curves = 6;
    if (!is_grid(sweep)) return one_cloud(axis, values);
    std::vector<std::string> names;
    std::map<std::string, std::vector<std::pair<double, double>>> points;
    for (std::size_t k = 0; k < outcomes.size(); ++k) {
        const std::string name = curve_name(sweep, varied, k, outcomes);
        if (!points.contains(name)) names.push_back(name);
        points[name].emplace_back(axis.values[k], values[k]);
    }
    if (names.size() > most_curves) return one_cloud(axis, values);
    std::vector<PlotCurve> curves;
    for (std::size_t c = 0; c < names.size(); ++c) {
        std::vector<std::pair<double, double>>& places = points[names[c]];
        std::stable_sort(places.begin(), places.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        PlotCurve curve{names[c], curve_colour(c, names.size()), {}, {}, CurveStyle::line_with_points};
        for (const auto& [x, y] : places) {
            curve.x.push_back(x);
            curve.y.push_back(y);
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

/// Texts are numbered in the order in which they appear, and the label says which is which.
KeyAxis text_axis(const std::string& key, std::size_t varied, const std::vector<SweepOutcome>& outcomes)
{
    std::vector<std::string> texts;
    KeyAxis axis{key, {}};
    for (const SweepOutcome& outcome : outcomes) {
        const std::string& text = outcome.checked.values[varied].text;
        auto found = std::find(texts.begin(), texts.end(), text);
        if (found == texts.end()) found = texts.insert(texts.end(), text);
        axis.values.push_back(static_cast<double>(found - texts.begin()) + 1.0);
    }
    constexpr std::size_t most_named = 4;
    for (std::size_t k = 0; k < std::min(most_named, texts.size()); ++k)
        axis.label += fmt::format("{} {}: {}", k == 0 ? "," : ";", k + 1, texts[k]);
    return axis;
}

std::string note_of(const std::vector<SweepOutcome>& outcomes)
{
    const auto finished = std::count_if(outcomes.begin(), outcomes.end(),
                                        [](const SweepOutcome& each) { return each.state == "finished"; });
    return fmt::format("largest amounts; {} of {} runs are finished", finished, outcomes.size());
}

} // namespace

KeyAxis axis_of(const Sweep& sweep, std::size_t varied, const std::vector<SweepOutcome>& outcomes)
{
    const std::string& key = sweep.varied[varied].key;
    std::vector<double> values;
    for (const SweepOutcome& outcome : outcomes) values.push_back(outcome.checked.values[varied].number);
    if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
        return text_axis(key, varied, outcomes);
    const DisplayUnit unit = shown_unit(varied, outcomes);
    return {label_with_unit(key, unit), scaled(values, unit), unit.factor};
}

std::vector<LinePlot> sweep_plots(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes)
{
    constexpr std::size_t in_a_plot = 3;
    const DrawnQuantity quantity = drawn_quantity(outcomes);
    std::vector<LinePlot> plots;
    if (quantity.values.empty()) return plots;
    const DisplayUnit unit = display_unit("m", largest_of(quantity.values));
    const std::vector<double> values = scaled(quantity.values, unit);
    for (std::size_t v = 0; v < sweep.varied.size(); ++v) {
        if (v % in_a_plot == 0)
            plots.push_back({sweep.title.empty() ? sweep.file.stem().string() : sweep.title,
                             note_of(outcomes),
                             {},
                             PlotArrangement::side_by_side});
        const KeyAxis axis = axis_of(sweep, v, outcomes);
        PlotPanel panel{axis.label, label_with_unit(quantity.label, unit),
                        curves_of(sweep, v, axis, values, outcomes), KeyPlace::upper_left};
        plots.back().panels.push_back(std::move(panel));
    }
    return plots;
}

} // namespace quicksand
