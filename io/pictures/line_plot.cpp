#include "io/pictures/line_plot.hpp"

#include <algorithm>

namespace quicksand {
namespace {

// Sizes of the sheet and its margins [pixel].
constexpr double stack_width = 1200.0, stack_panel = 170.0, stack_alone = 430.0, stack_gap = 46.0;
constexpr double beside_width = 600.0, beside_panel = 560.0;
constexpr double left_of_axes = 112.0, right_of_axes = 36.0, above_axes = 120.0, below_axes = 76.0;
// Right of the axes where the key stands beside them: its samples, and a letter of a name.
constexpr double key_samples = 76.0, key_letter = 8.3, least_key = 210.0;

double margin_for_keys(const LinePlot& plot)
{
    double margin = right_of_axes;
    for (const PlotPanel& panel : plot.panels) {
        if (panel.key != KeyPlace::beside) continue;
        margin = std::max(margin, least_key);
        for (const PlotCurve& curve : panel.curves)
            margin = std::max(margin, key_samples + key_letter * static_cast<double>(curve.name.size()));
    }
    return margin;
}

/// The x axis has its label below the last panel alone; the labels of y lie above the axes, where long ones
/// have room.
void draw_stacked(const LinePlot& plot, Drawing& drawing)
{
    const auto count = static_cast<double>(plot.panels.size());
    PixelBox box{left_of_axes, above_axes, stack_width - left_of_axes - margin_for_keys(plot),
                 count > 1.0 ? stack_panel : stack_alone};
    std::vector<PlotCurve> curves;
    for (const PlotPanel& panel : plot.panels)
        curves.insert(curves.end(), panel.curves.begin(), panel.curves.end());
    const std::optional<PlotRange> shared = values_of(curves, &PlotCurve::x);
    for (std::size_t p = 0; p < plot.panels.size(); ++p, box.top += box.height + stack_gap) {
        PlotPanel panel = plot.panels[p];
        if (panel.x_scale == AxisScale::linear) panel.x_range = shared;
        drawing.commands += label_at(box.left, box.top - 13.0, panel.y_label, "");
        panel.y_label.clear();
        if (p + 1 < plot.panels.size()) panel.x_label.clear();
        drawing.commands += panel_commands(panel, box);
    }
    drawing.width = stack_width;
    drawing.height = box.top - stack_gap + below_axes;
}

void draw_side_by_side(const LinePlot& plot, Drawing& drawing)
{
    PixelBox box{left_of_axes, above_axes, beside_width - left_of_axes - right_of_axes, beside_panel};
    for (const PlotPanel& panel : plot.panels) {
        drawing.commands += panel_commands(panel, box);
        box.left += beside_width;
    }
    drawing.width = box.left - left_of_axes + margin_for_keys(plot) - right_of_axes;
    drawing.height = box.bottom() + below_axes;
}

} // namespace

Drawing plot_drawing(const LinePlot& plot, const std::filesystem::path& png)
{
    Drawing drawing;
    drawing.png = png;
    drawing.commands = "set multiplot\n" + label_at(left_of_axes, 34.0, plot.title, "font ':Bold,16'") +
                       label_at(left_of_axes, 62.0, plot.note, "font ',11' textcolor rgb '#606060'");
    if (plot.arrangement == PlotArrangement::stacked) {
        draw_stacked(plot, drawing);
    } else {
        draw_side_by_side(plot, drawing);
    }
    drawing.commands += "unset multiplot\n";
    return drawing;
}

} // namespace quicksand
