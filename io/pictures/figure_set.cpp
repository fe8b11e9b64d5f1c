#include "io/pictures/figure_set.hpp"

#include "io/files/file_error.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"
#include "io/pictures/picture_isochrones.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/pictures/picture_ticks.hpp"
#include "io/results/results_folder.hpp"
#include "io/scene/scene_base.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// What a length, velocity or acceleration is multiplied by in the figure.
double factor_of(const SceneFigure& figure)
{
    return figure.quantity->sign * std::pow(figure.scale, figure.quantity->quantity->length_power);
}

std::vector<double> times(double factor, const std::vector<double>& values)
{
    std::vector<double> result;
    for (const double value : values) result.push_back(factor * value);
    return result;
}

std::string scale_note(const SceneFigure& figure)
{
    return figure.scale == 1.0
               ? ""
               : fmt::format("in full scale: lengths and times of the run × {:g}", figure.scale);
}

/// The first value of a column that is one; NaN without any.
double first_value(const std::vector<double>* column)
{
    if (column == nullptr) return NAN;
    const auto found =
        std::find_if(column->begin(), column->end(), [](double value) { return std::isfinite(value); });
    return found == column->end() ? NAN : *found;
}

struct Series {
    std::string name;
    std::vector<double> time;   // [s]
    std::vector<double> values; // SI
    double limit = NAN;         // a level to draw beside it, SI
};

std::vector<Series> series_of(const SceneFigure& figure, const std::vector<FigureProbe>& probes)
{
    std::vector<Series> all;
    for (const FigureProbe& probe : probes) {
        const auto* time = probe.table.find("time_s");
        const auto* values = probe.table.find(figure.quantity->column());
        if (time == nullptr || values == nullptr || largest_of(*values) < 0.0) continue;
        Series series{probe.name, times(figure.scale, *time), times(factor_of(figure), *values)};
        if (figure.quantity->name == "excess_pore_pressure")
            series.limit =
                first_value(probe.table.find(probe_column(quantity_named("vertical_effective_stress"), 0)));
        all.push_back(std::move(series));
    }
    return all;
}

/// Rows [begin, end) of the profiles nearest to the times, in their order.
std::vector<ProfileRows> profiles_at(const std::vector<double>& rows, const std::vector<double>& wanted)
{
    if (wanted.empty()) return choose_profiles(rows, isochrone_count);
    const std::vector<ProfileRows> all = choose_profiles(rows, rows.size());
    std::vector<ProfileRows> chosen;
    for (const double time : wanted) {
        chosen.push_back(*std::min_element(all.begin(), all.end(), [time](const auto& a, const auto& b) {
            return std::abs(a.time - time) < std::abs(b.time - time);
        }));
    }
    return chosen;
}

bool is_upright(const PictureTable& table)
{
    const auto width = [&](const char* column) {
        const auto* values = table.find(column);
        if (values == nullptr || values->empty()) return 0.0;
        const auto [low, high] = std::minmax_element(values->begin(), values->end());
        return *high - *low;
    };
    return width("y_m") >= width("x_m");
}

Drawing field_figure(const fs::path& results, const SceneFigure& figure, const fs::path& file,
                     const std::function<void(const std::string&)>& notify)
{
    PictureRequest request;
    request.output = file;
    request.field = figure.field;
    request.time = figure.time;
    request.title = figure.title;
    if (figure.range.size() == 2) request.range = PlotRange{figure.range[0], figure.range[1]};
    request.notify = notify;
    return result_drawings(results, request).front();
}

std::vector<FigureProbe> read_figure_probes(const fs::path& results, const SceneFigure& figure)
{
    std::vector<FigureProbe> probes;
    for (const std::string& name : figure.probes) {
        const fs::path file = ResultsFolder{results}.probe(name);
        if (!fs::exists(file))
            throw InputError(
                fmt::format("figure {}: the results have no {}\nhint: the scene of the run had no "
                            "such probe; run it again",
                            figure.name, file.string()));
        probes.push_back({name, read_picture_table(file)});
    }
    return probes;
}

std::optional<LinePlot> line_figure(const fs::path& results, const SceneFigure& figure)
{
    const std::vector<FigureProbe> probes = read_figure_probes(results, figure);
    return figure.kind == FigureKind::history ? history_figure(figure, probes)
                                              : isochrone_figure(figure, probes.front());
}

} // namespace

std::vector<SceneFigure> figures_of_scene(const fs::path& scene)
{
    Diagnostics findings;
    const auto text = read_text_file(scene, {scene, 0, 0}, findings);
    auto document = text ? read_document(scene, *text, {}, findings) : std::nullopt;
    if (document) document = merge_with_base(scene, std::move(*document), findings);
    std::vector<SceneFigure> figures;
    if (document) {
        const SceneValues values = check_document(scene_key_table(), *document, findings);
        if (!findings.has_errors()) figures = read_figures(values, findings);
    }
    if (!findings.has_errors()) return figures;
    throw_findings(findings, text ? *text : "");
}

std::optional<LinePlot> history_figure(const SceneFigure& figure, const std::vector<FigureProbe>& probes)
{
    std::vector<Series> all = series_of(figure, probes);
    double magnitude = -1.0;
    for (const Series& series : all) {
        magnitude = std::max(magnitude, largest_of(series.values));
        if (std::isfinite(series.limit)) magnitude = std::max(magnitude, std::abs(series.limit));
    }
    if (magnitude < 0.0) return std::nullopt;
    const DisplayUnit unit = display_unit(drawn_unit(*figure.quantity->quantity), magnitude);
    PlotPanel panel{"Time [s]", label_with_unit(figure.quantity->label, unit), {}, KeyPlace::beside};
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Series& series = all[k];
        const Colour colour = curve_colour(k, all.size());
        panel.curves.push_back({series.name, colour, series.time, scaled(series.values, unit)});
        if (!std::isfinite(series.limit)) continue;
        const std::vector<double> level(2, series.limit);
        panel.curves.push_back({"ru = 1",
                                colour,
                                {series.time.front(), series.time.back()},
                                scaled(level, unit),
                                CurveStyle::dashed});
    }
    return LinePlot{figure.title, scale_note(figure), {std::move(panel)}, PlotArrangement::stacked};
}

std::optional<LinePlot> isochrone_figure(const SceneFigure& figure, const FigureProbe& profile)
{
    const PictureTable& table = profile.table;
    const bool upright = is_upright(table);
    const auto* rows = table.find("time_s");
    const auto* places = table.find(upright ? "y_m" : "distance_m");
    const auto* values = table.find(figure.quantity->column());
    if (rows == nullptr || rows->empty() || places == nullptr || values == nullptr ||
        largest_of(*values) < 0.0)
        return std::nullopt;
    const DisplayUnit unit = display_unit(drawn_unit(*figure.quantity->quantity),
                                          std::abs(factor_of(figure)) * largest_of(*values));
    PlotPanel panel{label_with_unit(figure.quantity->label, unit),
                    upright ? "Height y [m]" : "Distance along the profile [m]",
                    {},
                    KeyPlace::beside};
    const std::vector<ProfileRows> chosen = profiles_at(*rows, figure.times);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const auto part = [&](const std::vector<double>& column) {
            return std::vector<double>(column.begin() + static_cast<std::ptrdiff_t>(chosen[k].begin),
                                       column.begin() + static_cast<std::ptrdiff_t>(chosen[k].end));
        };
        const double fraction =
            chosen.size() > 1 ? static_cast<double>(k) / static_cast<double>(chosen.size() - 1) : 0.0;
        PlotCurve curve{"t = " + time_text(figure.scale * chosen[k].time),
                        map_colour(ColourMap::sequential, 0.9 * fraction),
                        scaled(times(factor_of(figure), part(*values)), unit),
                        times(figure.scale, part(*places))};
        if (!upright) std::swap(curve.x, curve.y);
        panel.curves.push_back(std::move(curve));
    }
    if (!upright) std::swap(panel.x_label, panel.y_label);
    return LinePlot{figure.title, scale_note(figure), {std::move(panel)}, PlotArrangement::side_by_side};
}

std::vector<fs::path> draw_figures(const fs::path& results, const std::vector<SceneFigure>& figures,
                                   const fs::path& folder,
                                   const std::function<void(const std::string&)>& notify)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot make the folder", error.message(), "");
    std::vector<Drawing> drawings;
    for (const SceneFigure& figure : figures) {
        const fs::path file = folder / (figure.name + ".png");
        if (figure.kind == FigureKind::field) {
            drawings.push_back(field_figure(results, figure, file, notify));
        } else if (const auto plot = line_figure(results, figure)) {
            drawings.push_back(plot_drawing(*plot, file));
        } else {
            notify(fmt::format("figure {}: the results have no values of it", figure.name));
        }
    }
    return draw_pictures(drawings);
}

} // namespace quicksand
