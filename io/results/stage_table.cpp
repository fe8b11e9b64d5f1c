#include "io/results/stage_table.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/results/results_folder.hpp"
#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* table_file = "stages.csv";
constexpr const char* series_file = "stages.pvd";

const std::vector<std::string>& columns()
{
    static const std::vector<std::string> names = {"stage",   "kind",       "status",
                                                   "start_s", "duration_s", "factor_of_safety"};
    return names;
}

/// The frames of all stages on one clock. A stage begins with the frame that the one before ends with.
std::vector<FrameEntry> all_frames(const fs::path& results, const std::vector<StageRow>& stages)
{
    std::vector<FrameEntry> all;
    for (const StageRow& stage : stages) {
        const fs::path index = ResultsFolder{results / stage.name}.particle_series();
        if (stage.kind == "stability" || !fs::exists(index)) continue;
        for (const FrameEntry& frame : read_series_index(index)) {
            const double time = stage.start + frame.time;
            if (!all.empty() && all.back().time >= time) all.pop_back();
            all.push_back({time, stage.name / frame.file});
        }
    }
    return all;
}

/// The last stage that `suits`, the results themselves where there is none.
template <class Suits>
fs::path last_stage(const fs::path& results, const std::vector<StageRow>& stages, Suits&& suits)
{
    const auto found = std::find_if(stages.rbegin(), stages.rend(), suits);
    return found == stages.rend() ? results : results / found->name;
}

} // namespace

std::vector<StageRow> read_stage_table(const fs::path& results)
{
    if (!fs::exists(results / table_file)) return {};
    std::istringstream text(read_text(results / table_file));
    std::vector<StageRow> stages;
    std::string line;
    bool in_rows = false;
    while (std::getline(text, line)) {
        if (line.empty() || line.front() == '#') continue;
        const CsvRow cells = csv_cells(line);
        if (cells.size() != columns().size())
            throw InputError((results / table_file).string() + ": this is no table of stages");
        if (!std::exchange(in_rows, true)) continue; // names of the columns
        StageRow row{cells[0], cells[1], cells[2], csv_value(cells[3]), csv_value(cells[4])};
        if (const double factor = csv_value(cells[5]); !std::isnan(factor)) row.factor_of_safety = factor;
        stages.push_back(std::move(row));
    }
    return stages;
}

std::vector<fs::path> stages_up_to(const fs::path& results)
{
    const fs::path folder = fs::weakly_canonical(results);
    std::vector<fs::path> folders;
    for (const StageRow& stage : read_stage_table(folder.parent_path())) {
        folders.push_back(folder.parent_path() / stage.name);
        if (stage.name == folder.filename()) return folders;
    }
    return {results};
}

void write_stage_table(const fs::path& results, const std::vector<StageRow>& stages)
{
    std::string text =
        csv_header({"Quicksand stages: each has a folder of its name with the results of a run",
                    "start_s: on the clock of all stages, which stands still while soil settles"},
                   columns());
    for (const StageRow& stage : stages) {
        text += stage.name + "," + stage.kind + "," + stage.status + "," + csv_number(stage.start) + "," +
                csv_number(stage.duration) + "," + csv_number(stage.factor_of_safety.value_or(std::nan(""))) +
                "\n";
    }
    write_atomically(results / table_file, text);
    write_series_index(results / series_file, all_frames(results, stages));
}

fs::path with_end(const fs::path& results)
{
    return last_stage(results, read_stage_table(results),
                      [](const StageRow& stage) { return stage.kind != "stability"; });
}

fs::path with_histories(const fs::path& results)
{
    const std::vector<StageRow> stages = read_stage_table(results);
    const fs::path shaken =
        last_stage(results, stages, [](const StageRow& stage) { return stage.kind == "shake"; });
    return shaken == results ? with_end(results) : shaken;
}

} // namespace quicksand
