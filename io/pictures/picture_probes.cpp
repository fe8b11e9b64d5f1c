#include "io/pictures/picture_probes.hpp"

#include "io/pictures/picture_isochrones.hpp"
#include "io/pictures/picture_ticks.hpp"
#include "solver/measure/body_quantities.hpp"
#include "solver/measure/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace quicksand {
namespace {

constexpr const char* time_label = "Time [s]";

/// Of a quantity at probes.
PanelPlan plan_of(const char* name)
{
    const Quantity& quantity = quantity_named(name);
    PanelPlan plan{std::string(quantity.label), std::string(drawn_unit(quantity)), {}};
    if (quantity.form == QuantityForm::scalar) {
        plan.columns = {{probe_column(quantity, 0), ""}};
    } else {
        plan.columns = {{probe_column(quantity, 0), "horizontal"},
                        {probe_column(quantity, 1), "vertical, up"}};
    }
    return plan;
}

/// None where the table has no values for it.
std::optional<PlotPanel> make_panel(const PanelPlan& plan, const PictureTable& table)
{
    const std::vector<double>* time = table.find("time_s");
    double magnitude = -1.0;
    for (const PanelColumn& column : plan.columns)
        if (const auto* values = table.find(column.column))
            magnitude = std::max(magnitude, largest_of(*values));
    if (time == nullptr || magnitude < 0.0) return std::nullopt;

    const DisplayUnit unit = display_unit(plan.unit, magnitude);
    PlotPanel panel{time_label, label_with_unit(plan.label, unit), {}};
    for (std::size_t c = 0; c < plan.columns.size(); ++c) {
        const std::vector<double>* values = table.find(plan.columns[c].column);
        if (values == nullptr || largest_of(*values) < 0.0) continue;
        panel.curves.push_back(
            {plan.columns[c].name, curve_colour(c, plan.columns.size()), *time, scaled(*values, unit)});
    }
    return panel;
}

std::vector<PlotPanel> make_panels(const std::vector<PanelPlan>& plans, const PictureTable& table)
{
    std::vector<PlotPanel> panels;
    for (const PanelPlan& plan : plans)
        if (auto panel = make_panel(plan, table)) panels.push_back(std::move(*panel));
    return panels;
}

/// "fixed: the point (0.1, 0.2) m" from the comment "probe: P1, fixed: the point (0.1, 0.2) m, interpolated
/// in ..."
std::string place_of(const PictureTable& table, const std::string& name)
{
    std::string place = table.comment("probe: ");
    if (place.starts_with(name + ", ")) place.erase(0, name.size() + 2);
    const std::size_t end = place.find(") m");
    return end == std::string::npos ? place : place.substr(0, end + 3);
}

} // namespace

std::vector<PanelPlan> probe_plan()
{
    std::vector<PanelPlan> plans;
    for (const char* name : {"excess_pore_pressure", "ru", "displacement", "velocity_solid", "acceleration"})
        plans.push_back(plan_of(name));
    return plans;
}

std::vector<PanelPlan> history_plan()
{
    std::vector<PanelPlan> plans;
    for (const BodyQuantity& quantity : all_body_quantities()) {
        if (quantity.label.empty()) continue;
        const std::string_view si = quantity.unit == "-" ? "" : quantity.unit;
        plans.push_back({std::string(quantity.label),
                         std::string(quantity.drawn.empty() ? si : quantity.drawn),
                         {{column_name(quantity), ""}}});
    }
    return plans;
}

std::optional<LinePlot> probe_plot(const PictureTable& table, const std::string& name)
{
    if (table.find("distance_m") != nullptr) return isochrone_plot(table, name);
    std::vector<PlotPanel> panels = make_panels(probe_plan(), table);
    if (table.find("excess_pore_pressure_Pa") == nullptr)
        if (auto stress = make_panel(plan_of("mean_effective_stress"), table))
            panels.insert(panels.begin(), std::move(*stress));
    if (panels.empty()) return std::nullopt;
    return LinePlot{"Probe " + name, place_of(table, name), std::move(panels), PlotArrangement::stacked};
}

std::optional<LinePlot> comparison_plot(const std::vector<ProbeTable>& probes)
{
    struct Member {
        const ProbeTable* probe;
        const std::vector<double>* pressure;
    };
    std::vector<Member> members;
    double magnitude = 0.0;
    for (const ProbeTable& probe : probes) {
        const auto* pressure = probe.table.find("excess_pore_pressure_Pa");
        const bool rides = probe.table.comment("probe: ").find(", material:") != std::string::npos;
        if (!rides || pressure == nullptr || largest_of(*pressure) < 0.0) continue;
        members.push_back({&probe, pressure});
        magnitude = std::max(magnitude, largest_of(*pressure));
    }
    if (members.size() < 2) return std::nullopt;

    const DisplayUnit unit = display_unit("Pa", magnitude);
    PlotPanel panel{time_label, label_with_unit("Excess pore pressure", unit), {}, KeyPlace::beside};
    for (std::size_t k = 0; k < members.size(); ++k)
        panel.curves.push_back({members[k].probe->name, curve_colour(k, members.size()),
                                *members[k].probe->table.find("time_s"), scaled(*members[k].pressure, unit)});
    return LinePlot{"Excess pore pressure",
                    "probes that move with the soil",
                    {std::move(panel)},
                    PlotArrangement::stacked};
}

std::optional<LinePlot> history_plot(const PictureTable& table)
{
    std::vector<PlotPanel> panels = make_panels(history_plan(), table);
    if (panels.empty()) return std::nullopt;
    return LinePlot{"History of the whole section",
                    "settlement positive downward; sums per metre of thickness", std::move(panels),
                    PlotArrangement::stacked};
}

std::vector<ProbeTable> read_probes(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".csv") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<ProbeTable> probes;
    for (const auto& file : files) probes.push_back({file.stem().string(), read_picture_table(file)});
    return probes;
}

std::vector<Drawing> probe_drawings(const std::filesystem::path& results, const std::filesystem::path& folder)
{
    std::vector<Drawing> drawings;
    const auto draw = [&](const std::optional<LinePlot>& plot, const std::string& stem) {
        if (plot) drawings.push_back(plot_drawing(*plot, folder / (stem + ".png")));
    };
    const std::vector<ProbeTable> probes = read_probes(results / "probes");
    for (const ProbeTable& probe : probes) draw(probe_plot(probe.table, probe.name), "probe_" + probe.name);
    draw(comparison_plot(probes), "probes_excess_pore_pressure");
    const std::filesystem::path history = results / "history.csv";
    if (std::filesystem::exists(history)) draw(history_plot(read_picture_table(history)), "history");
    return drawings;
}

} // namespace quicksand
