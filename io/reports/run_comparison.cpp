#include "io/reports/run_comparison.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/pictures/picture_ticks.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_summary.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The last `parts` names of the path: "b" or "a/b".
std::string last_names(const fs::path& folder, int parts)
{
    fs::path name;
    fs::path rest = fs::absolute(folder / "").lexically_normal().parent_path();
    for (int k = 0; k < parts && rest.has_filename(); ++k, rest = rest.parent_path())
        name = name.empty() ? rest.filename() : rest.filename() / name;
    return name.string();
}

/// As many of the last names of each folder as tell them apart.
std::vector<std::string> names_of(const std::vector<fs::path>& folders)
{
    std::vector<std::string> names;
    for (int parts = 1; parts < 20; ++parts) {
        names.clear();
        for (const fs::path& folder : folders) names.push_back(last_names(folder, parts));
        std::vector<std::string> sorted = names;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) break;
    }
    return names;
}

void require_different(const std::vector<fs::path>& folders)
{
    std::error_code ignored;
    for (std::size_t a = 0; a < folders.size(); ++a)
        for (std::size_t b = a + 1; b < folders.size(); ++b)
            if (fs::equivalent(folders[a], folders[b], ignored))
                throw InputError(folders[b].string() + " is named twice: nothing differs");
}

const ProbeTable* find_table(const ComparedRun& run, const std::string& name)
{
    const auto found = std::find_if(run.tables.begin(), run.tables.end(),
                                    [&](const ProbeTable& table) { return table.name == name; });
    return found == run.tables.end() ? nullptr : &*found;
}

/// A column of one run and its times; null where it has none, or no values.
struct Series {
    const std::vector<double>* times = nullptr;
    const std::vector<double>* values = nullptr;
    explicit operator bool() const
    {
        return times != nullptr && values != nullptr && largest_of(*values) >= 0.0;
    }
};

Series series_of(const ComparedRun& run, const std::string& table, const std::string& column)
{
    const ProbeTable* found = find_table(run, table);
    if (found == nullptr) return {};
    return {found->table.find("time_s"), found->table.find(column)};
}

/// Linear between the rows, NaN outside them.
double value_at(const Series& series, double time)
{
    const std::vector<double>& times = *series.times;
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    if (after == times.end()) return no_value;
    const auto k = static_cast<std::size_t>(after - times.begin());
    if (*after == time) return (*series.values)[k];
    if (k == 0) return no_value;
    const double weight = (time - times[k - 1]) / (times[k] - times[k - 1]);
    return (1.0 - weight) * (*series.values)[k - 1] + weight * (*series.values)[k];
}

double rms_difference(const Series& first, const Series& other)
{
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < first.times->size(); ++k) {
        const double difference = value_at(other, (*first.times)[k]) - (*first.values)[k];
        if (!std::isfinite(difference)) continue;
        sum += difference * difference;
        count += 1.0;
    }
    return count > 0.0 ? std::sqrt(sum / count) : no_value;
}

/// Peak and final value of a series, which has finite ones.
void measure_series(const Series& series, ComparedValue& value)
{
    double largest = -1.0;
    for (std::size_t k = 0; k < series.values->size(); ++k) {
        const double present = (*series.values)[k];
        if (!std::isfinite(present)) continue;
        value.final_value = present;
        if (std::abs(present) <= largest) continue;
        largest = std::abs(present);
        value.peak = present;
        value.peak_time = (*series.times)[k];
    }
}

/// The rows of one column, none where only one of several runs has it.
std::vector<ComparedValue> compare_column(const std::vector<ComparedRun>& runs, const std::string& table,
                                          const std::string& column)
{
    std::vector<ComparedValue> rows;
    Series first;
    for (const ComparedRun& run : runs) {
        const Series series = series_of(run, table, column);
        if (!series) continue;
        ComparedValue row{table, column, run.name};
        measure_series(series, row);
        row.peak_change = row.final_change = row.rms_difference = no_value;
        if (rows.empty()) {
            first = series;
        } else {
            row.peak_change = std::abs(row.peak) - std::abs(rows.front().peak);
            row.final_change = row.final_value - rows.front().final_value;
            row.rms_difference = rms_difference(first, series);
        }
        rows.push_back(std::move(row));
    }
    return rows.size() > 1 || runs.size() == 1 ? rows : std::vector<ComparedValue>();
}

/// One panel a quantity, with a curve of each run that has it; for columns of several parts one panel each.
std::vector<PlotPanel> panels_of(const std::vector<ComparedRun>& runs, const std::string& table,
                                 const std::vector<PanelPlan>& plans)
{
    std::vector<PlotPanel> panels;
    for (const PanelPlan& plan : plans)
        for (const PanelColumn& column : plan.columns) {
            double magnitude = -1.0;
            for (const ComparedRun& run : runs)
                if (const Series series = series_of(run, table, column.column))
                    magnitude = std::max(magnitude, largest_of(*series.values));
            if (magnitude < 0.0) continue;
            const DisplayUnit unit = display_unit(plan.unit, magnitude);
            const std::string label = column.name.empty() ? plan.label : plan.label + ", " + column.name;
            PlotPanel panel{"Time [s]", label_with_unit(label, unit), {}};
            for (std::size_t r = 0; r < runs.size(); ++r) {
                const Series series = series_of(runs[r], table, column.column);
                if (!series) continue;
                panel.curves.push_back({panels.empty() ? runs[r].name : "", curve_colour(r, runs.size()),
                                        *series.times, scaled(*series.values, unit)});
            }
            panels.push_back(std::move(panel));
        }
    return panels;
}

/// The names of tables, those of the first run before what only others have.
std::vector<std::string> table_names(const std::vector<ComparedRun>& runs)
{
    std::vector<std::string> names;
    for (const ComparedRun& run : runs)
        for (const ProbeTable& table : run.tables)
            if (std::find(names.begin(), names.end(), table.name) == names.end()) names.push_back(table.name);
    return names;
}

std::vector<PanelPlan> plans_of(const std::string& table)
{
    return table == history_name ? history_plan() : probe_plan();
}

} // namespace

std::vector<ComparedRun> read_compared_runs(const std::vector<fs::path>& folders)
{
    require_different(folders);
    const std::vector<std::string> names = names_of(folders);
    std::vector<ComparedRun> runs;
    for (std::size_t k = 0; k < folders.size(); ++k) {
        const ResultsFolder folder{folders[k]};
        ComparedRun run{names[k], folders[k], {}};
        if (fs::exists(folder.history()))
            run.tables.push_back({history_name, read_picture_table(folder.history())});
        for (ProbeTable& probe : read_probes(folders[k] / "probes"))
            if (probe.table.find("distance_m") == nullptr) run.tables.push_back(std::move(probe));
        if (run.tables.empty())
            throw InputError(
                "there are no results in " + folders[k].string() +
                ": neither history.csv nor probes/*.csv\nhint: name the results folder of a run");
        runs.push_back(std::move(run));
    }
    return runs;
}

std::vector<ComparedValue> compare_runs(const std::vector<ComparedRun>& runs)
{
    std::vector<ComparedValue> values;
    for (const std::string& table : table_names(runs)) {
        std::vector<std::string> columns;
        for (const ComparedRun& run : runs)
            if (const ProbeTable* found = find_table(run, table))
                for (const std::string& column : found->table.columns)
                    if (column != "time_s" &&
                        std::find(columns.begin(), columns.end(), column) == columns.end())
                        columns.push_back(column);
        for (const std::string& column : columns)
            for (ComparedValue& row : compare_column(runs, table, column)) values.push_back(std::move(row));
    }
    return values;
}

void write_comparison(const fs::path& path, const std::vector<ComparedValue>& values,
                      const std::vector<std::string>& comments)
{
    std::string text = csv_header(comments, {"table", "quantity", "run", "peak", "peak_time_s", "final",
                                             "peak_change", "final_change", "rms_difference"});
    for (const ComparedValue& value : values) {
        const CsvRow cells{value.table,
                           value.column,
                           csv_text(value.run),
                           csv_number(value.peak),
                           csv_number(value.peak_time),
                           csv_number(value.final_value),
                           csv_number(value.peak_change),
                           csv_number(value.final_change),
                           csv_number(value.rms_difference)};
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    write_atomically(path, text);
}

bool is_drawn(const ComparedValue& value)
{
    for (const PanelPlan& plan : plans_of(value.table))
        for (const PanelColumn& column : plan.columns)
            if (column.column == value.column) return true;
    return false;
}

std::vector<Drawing> comparison_drawings(const std::vector<ComparedRun>& runs, const fs::path& folder)
{
    std::vector<Drawing> drawings;
    for (const std::string& table : table_names(runs)) {
        std::vector<PlotPanel> panels = panels_of(runs, table, plans_of(table));
        if (panels.empty()) continue;
        const bool history = table == history_name;
        const LinePlot plot{history ? "History of the whole section" : "Probe " + table,
                            history ? "settlement positive downward; sums per metre of thickness" : "",
                            std::move(panels), PlotArrangement::stacked};
        drawings.push_back(plot_drawing(plot, folder / ((history ? "" : "probe_") + table + ".png")));
    }
    return drawings;
}

} // namespace quicksand
