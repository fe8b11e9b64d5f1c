#include "io/pictures/picture_isochrones.hpp"

#include "io/keys/scene_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quicksand {
namespace {

/// The place along the profile: the height of a steep one, the distance along a flat one.
struct PlaceColumn {
    const std::vector<double>* values = nullptr; // [m]
    std::string label;
    bool upright = false;
};

double span(const std::vector<double>& values)
{
    double low = INFINITY, high = -INFINITY;
    for (const double value : values)
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    return high - low;
}

PlaceColumn place_column(const PictureTable& table)
{
    const std::vector<double>* x = table.find("x_m");
    const std::vector<double>* y = table.find("y_m");
    if (x != nullptr && y != nullptr && span(*y) >= span(*x)) return {y, "y [m]", true};
    return {table.find("distance_m"), "Distance along the profile [m]", false};
}

std::vector<double> slice(const std::vector<double>& values, const ProfileRows& rows)
{
    return {values.begin() + static_cast<std::ptrdiff_t>(rows.begin),
            values.begin() + static_cast<std::ptrdiff_t>(rows.end)};
}

struct ProfileQuantity {
    const char* column;
    const char* label;
    const char* unit;
};

std::optional<PlotPanel> make_isochrone_panel(const ProfileQuantity& quantity, const PictureTable& table,
                                              const std::vector<ProfileRows>& profiles)
{
    const std::vector<double>* values = table.find(quantity.column);
    if (values == nullptr || largest_of(*values) < 0.0) return std::nullopt;
    const DisplayUnit unit = display_unit(quantity.unit, largest_of(*values));
    const PlaceColumn place = place_column(table);
    PlotPanel panel{label_with_unit(quantity.label, unit), place.label, {}};
    if (!place.upright) std::swap(panel.x_label, panel.y_label);
    for (std::size_t k = 0; k < profiles.size(); ++k) {
        const double fraction =
            profiles.size() > 1 ? static_cast<double>(k) / static_cast<double>(profiles.size() - 1) : 0.0;
        PlotCurve curve{"t = " + time_text(profiles[k].time),
                        map_colour(ColourMap::sequential, 0.9 * fraction),
                        scaled(slice(*values, profiles[k]), unit), slice(*place.values, profiles[k])};
        if (!place.upright) std::swap(curve.x, curve.y);
        panel.curves.push_back(std::move(curve));
    }
    return panel;
}

} // namespace

std::vector<ProfileRows> choose_profiles(const std::vector<double>& times, std::size_t count)
{
    std::vector<ProfileRows> all;
    for (std::size_t row = 0; row < times.size(); ++row) {
        if (all.empty() || times[row] != all.back().time) all.push_back({times[row], row, row});
        all.back().end = row + 1;
    }
    if (all.size() <= count || count < 2) return all;
    std::vector<ProfileRows> chosen;
    const double first = all.front().time, last = all.back().time;
    for (std::size_t k = 0; k < count; ++k) {
        const double wanted =
            first + (last - first) * static_cast<double>(k) / static_cast<double>(count - 1);
        const auto nearest = std::min_element(all.begin(), all.end(), [wanted](const auto& a, const auto& b) {
            return std::abs(a.time - wanted) < std::abs(b.time - wanted);
        });
        if (chosen.empty() || chosen.back().begin != nearest->begin) chosen.push_back(*nearest);
    }
    return chosen;
}

std::optional<LinePlot> isochrone_plot(const PictureTable& table, const std::string& name)
{
    constexpr std::array<ProfileQuantity, 2> wet{{{"excess_pore_pressure_Pa", "Excess pore pressure", "Pa"},
                                                  {"ux_m", "Horizontal displacement", "m"}}};
    constexpr std::array<ProfileQuantity, 2> dry{
        {{"mean_effective_stress_Pa", "Mean effective stress", "Pa"}, wet[1]}};
    const std::vector<double>* times = table.find("time_s");
    if (times == nullptr) return std::nullopt;
    const std::vector<ProfileRows> profiles = choose_profiles(*times, isochrone_count);

    LinePlot plot{"Profile " + name,
                  table.comment("probe: " + name + ", profile: "),
                  {},
                  PlotArrangement::side_by_side};
    plot.note = plot.note.substr(0, plot.note.find(", interpolated"));
    for (const ProfileQuantity& quantity : table.find(wet[0].column) != nullptr ? wet : dry)
        if (auto panel = make_isochrone_panel(quantity, table, profiles))
            plot.panels.push_back(std::move(*panel));
    if (plot.panels.empty()) return std::nullopt;

    // One key for all panels, beside the last.
    plot.panels.back().key = KeyPlace::beside;
    for (std::size_t p = 0; p + 1 < plot.panels.size(); ++p)
        for (PlotCurve& curve : plot.panels[p].curves) curve.name.clear();
    return plot;
}

} // namespace quicksand
