#include "io/pictures/verification_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

std::string name_of(const Convergence& result)
{
    const double order = measured_order(result);
    return result.quantity + (std::isfinite(order) ? fmt::format(", order {:.2f}", order) : "");
}

/// A line of a slope from the largest error on the coarsest grid.
PlotCurve slope_line(const std::vector<Convergence>& problem, int slope)
{
    PlotCurve line;
    line.name = fmt::format("slope {}", slope);
    line.colour = slope == 1 ? Colour{0.65, 0.65, 0.65} : Colour{0.3, 0.3, 0.3};
    line.style = CurveStyle::dashed;
    double largest = 0.0;
    for (const Convergence& result : problem) {
        if (std::isfinite(result.errors.front())) largest = std::max(largest, result.errors.front());
    }
    const std::vector<int>& cells = problem.front().cells;
    for (const int count : cells) {
        line.x.push_back(count);
        line.y.push_back(largest * std::pow(static_cast<double>(cells.front()) / count, slope));
    }
    return line;
}

} // namespace

LinePlot convergence_plot(const std::vector<Convergence>& problem)
{
    LinePlot plot;
    plot.title = problem.front().title + ": error against resolution";
    plot.note = "reference: " + problem.front().reference;
    plot.arrangement = PlotArrangement::side_by_side;
    PlotPanel panel;
    panel.x_label = fmt::format("cells along {:g} m", problem.front().length);
    panel.y_label = "relative error [-]";
    panel.key = KeyPlace::beside;
    panel.x_scale = AxisScale::series;
    panel.y_scale = AxisScale::logarithmic;
    for (std::size_t k = 0; k < problem.size(); ++k) {
        PlotCurve curve;
        curve.name = name_of(problem[k]);
        curve.colour = curve_colour(k, problem.size());
        curve.style = CurveStyle::line_with_points;
        curve.x.assign(problem[k].cells.begin(), problem[k].cells.end());
        for (const double error : problem[k].errors) {
            curve.y.push_back(std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN());
        }
        panel.curves.push_back(std::move(curve));
    }
    for (const int slope : {1, 2}) panel.curves.push_back(slope_line(problem, slope));
    plot.panels = {std::move(panel)};
    return plot;
}

} // namespace quicksand
