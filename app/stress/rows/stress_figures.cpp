#include "app/stress/rows/stress_figures.hpp"

#include "app/stress/rows/stress_summary.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double least_drawn = 1e-17; // zeros lie on a logarithmic axis, too [-]

PlotCurve limit_line(double value, std::size_t rows)
{
    PlotCurve line;
    line.colour = {0.5, 0.5, 0.5};
    line.style = CurveStyle::dashed;
    line.x = {1.0, static_cast<double>(rows)};
    line.y = {value, value};
    return line;
}

/// Where the groups begin, and behind them the number of rows.
std::vector<std::size_t> group_starts(const std::vector<RowOutcome>& outcomes)
{
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < outcomes.size(); ++k)
        if (k == 0 || outcomes[k].row.group != outcomes[k - 1].row.group) starts.push_back(k);
    starts.push_back(outcomes.size());
    return starts;
}

PlotPanel panel_of(const std::vector<RowOutcome>& outcomes, double RowOutcome::*value, AxisScale scale,
                   bool names_groups)
{
    PlotPanel panel;
    panel.x_label = "row of stress.csv";
    panel.key = KeyPlace::beside;
    panel.y_scale = scale;
    const std::vector<std::size_t> starts = group_starts(outcomes);
    for (std::size_t g = 0; g + 1 < starts.size(); ++g) {
        PlotCurve curve;
        if (names_groups) curve.name = outcomes[starts[g]].row.group;
        curve.colour = curve_colour(g, starts.size() - 1);
        curve.style = CurveStyle::points;
        for (std::size_t k = starts[g]; k < starts[g + 1]; ++k) {
            const double size = std::abs(outcomes[k].*value);
            curve.x.push_back(static_cast<double>(k) + 1.0);
            curve.y.push_back(scale == AxisScale::logarithmic ? std::fmax(size, least_drawn) : size);
            if (std::isnan(size)) curve.y.back() = size; // a gap
        }
        panel.curves.push_back(std::move(curve));
    }
    return panel;
}

} // namespace

LinePlot outcome_plot(const std::vector<RowOutcome>& outcomes)
{
    LinePlot plot;
    plot.title = "Stability laboratory";
    plot.note = "dashed: beyond it a run is of no use; margins are to lie between the lines";
    const auto add = [&](const char* label, double RowOutcome::*value, AxisScale scale,
                         const std::vector<double>& limits) {
        PlotPanel panel = panel_of(outcomes, value, scale, plot.panels.empty());
        panel.y_label = label;
        for (const double limit : limits) panel.curves.push_back(limit_line(limit, outcomes.size()));
        plot.panels.push_back(std::move(panel));
    };
    add("energy error [-]", &RowOutcome::energy_error, AxisScale::logarithmic, {worst_energy_error});
    add("numerical loss over the energy put in [-]", &RowOutcome::loss, AxisScale::logarithmic, {worst_loss});
    add("water error [-]", &RowOutcome::water_error, AxisScale::logarithmic, {worst_water_error});
    add("momentum error [-]", &RowOutcome::momentum_error, AxisScale::logarithmic, {});
    add("checkerboard [-]", &RowOutcome::checkerboard, AxisScale::logarithmic, {});
    add("largest stable step over the own one [-]", &RowOutcome::margin, AxisScale::linear,
        {least_margin, most_margin});
    add("run time [s]", &RowOutcome::seconds, AxisScale::logarithmic, {});
    return plot;
}

} // namespace quicksand
