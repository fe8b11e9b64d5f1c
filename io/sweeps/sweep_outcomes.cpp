#include "io/sweeps/sweep_outcomes.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_record.hpp"
#include "solver/base/failure.hpp"
#include "solver/measure/quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

SweepOutcome read_outcome(const CheckedRun& checked, const fs::path& folder)
{
    SweepOutcome outcome{checked, "missing", "", "", std::nan(""), {}};
    const ResultsFolder results{folder / checked.results};
    if (!fs::exists(results.manifest())) return outcome;
    try {
        RunRecord record = read_run_record(results.manifest());
        if (record.scene_hash != checked.hash) {
            outcome.state = "other";
            return outcome;
        }
        outcome.state = record.status;
        outcome.verdict = record.verdict;
        if (record.status == "failed") outcome.reason = record.exit_reason;
        outcome.wall_time = record.wall_time;
        outcome.summary = std::move(record.summary);
    } catch (const InputError& error) {
        outcome.state = "other";
        outcome.reason = error.what();
    }
    return outcome;
}

/// In quotes where it would break the line into wrong cells.
std::string cell(const std::string& text)
{
    return text.find_first_of(",\"\n") == std::string::npos ? text : csv_text(text);
}

void add_columns_of_keys(const Sweep& sweep, const CheckedRun& run, CsvRow& columns)
{
    for (std::size_t v = 0; v < sweep.varied.size(); ++v)
        columns.push_back(cell(column_of(sweep.varied[v], run.values[v])));
}

CsvRow first_cells(const CheckedRun& run)
{
    CsvRow cells{std::to_string(run.run.number), run.run.folder};
    for (const RunValue& value : run.values) cells.push_back(cell(value.text));
    return cells;
}

std::vector<std::string> comments_of(const Sweep& sweep)
{
    std::vector<std::string> comments{"Quicksand " + program_version(),
                                      "sweep: " + sweep.file.filename().string(),
                                      "scene: " + sweep.scene.filename().string()};
    for (const std::string& word : sweep.fixed) comments.push_back("set: " + word);
    return comments;
}

const SummaryValue* find_value(const SweepOutcome& outcome, const std::string& name)
{
    for (const SummaryValue& value : outcome.summary)
        if (column_of(value, "") == name) return &value;
    return nullptr;
}

} // namespace

std::vector<SweepOutcome> read_outcomes(const std::vector<CheckedRun>& runs, const fs::path& folder)
{
    std::vector<SweepOutcome> outcomes;
    for (const CheckedRun& run : runs) outcomes.push_back(read_outcome(run, folder));
    return outcomes;
}

std::string column_of(const SummaryValue& value, const std::string& kind)
{
    return (value.table == history_name ? "" : value.table + ".") + value.column + kind;
}

std::string column_of(const VariedKey& key, const RunValue& value)
{
    return key.key + (value.unit.empty() ? "" : unit_suffix(value.unit));
}

double value_of(const SweepOutcome& outcome, const std::string& quantity)
{
    if (const SummaryValue* value = find_value(outcome, quantity)) return value->peak;
    for (const std::string ending : {"_peak", "_final"}) {
        if (!quantity.ends_with(ending)) continue;
        const SummaryValue* value = find_value(outcome, quantity.substr(0, quantity.size() - ending.size()));
        if (value != nullptr) return ending == "_peak" ? value->peak : value->final_value;
    }
    return std::nan("");
}

std::vector<std::string> quantities_of(const std::vector<SweepOutcome>& outcomes)
{
    std::vector<std::string> names;
    for (const SweepOutcome& outcome : outcomes)
        for (const SummaryValue& value : outcome.summary)
            if (const std::string name = column_of(value, "");
                std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    return names;
}

void write_runs_csv(const fs::path& path, const Sweep& sweep, const std::vector<CheckedRun>& runs)
{
    CsvRow columns{"run", "folder"};
    add_columns_of_keys(sweep, runs.front(), columns);
    std::string text = csv_header(comments_of(sweep), columns);
    for (const CheckedRun& run : runs) text += fmt::format("{}\n", fmt::join(first_cells(run), ","));
    write_atomically(path, text);
}

void write_sweep_csv(const fs::path& path, const Sweep& sweep, const std::vector<SweepOutcome>& outcomes)
{
    CsvRow columns{"run", "folder"};
    add_columns_of_keys(sweep, outcomes.front().checked, columns);
    for (const char* column : {"state", "verdict", "wall_time_s"}) columns.emplace_back(column);
    const std::vector<std::string> quantities = quantities_of(outcomes);
    for (const std::string& quantity : quantities)
        for (const char* kind : {"_peak", "_final"}) columns.push_back(quantity + kind);
    columns.emplace_back("reason");
    std::vector<std::string> comments = comments_of(sweep);
    comments.emplace_back("_peak: the value that is largest in amount; _final: that of the last row");
    std::string text = csv_header(comments, columns);
    for (const SweepOutcome& outcome : outcomes) {
        CsvRow cells = first_cells(outcome.checked);
        cells.insert(cells.end(), {outcome.state, outcome.verdict, csv_number(outcome.wall_time)});
        for (const std::string& quantity : quantities)
            for (const char* kind : {"_peak", "_final"})
                cells.push_back(csv_number(value_of(outcome, quantity + kind)));
        cells.push_back(cell(outcome.reason));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    write_atomically(path, text);
}

} // namespace quicksand
