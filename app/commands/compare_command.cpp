#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "io/files/output_folder.hpp"
#include "io/reports/frame_difference.hpp"
#include "io/reports/run_comparison.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_manifest.hpp"
#include "io/results/stage_table.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* comparison_file = "compare.txt";

std::string number_cell(double value)
{
    return std::isnan(value) ? "" : short_number(value, 4);
}

/// One block a quantity, one line a run.
std::string describe(const std::vector<ComparedValue>& values, std::size_t name_width)
{
    std::string text = fmt::format("  {:<{}}{:>12}{:>10}{:>12}{:>12}{:>12}{:>12}\n", "", name_width + 2,
                                   "peak", "at s", "final", "peak +-", "final +-", "rms +-");
    std::string block;
    for (const ComparedValue& value : values) {
        if (!is_drawn(value)) continue;
        const std::string title = value.table + ": " + value.column;
        if (title != block) text += (block = title) + "\n";
        text += fmt::format("  {:<{}}{:>12}{:>10}{:>12}{:>12}{:>12}{:>12}\n", value.run, name_width + 2,
                            number_cell(value.peak), number_cell(value.peak_time),
                            number_cell(value.final_value), number_cell(value.peak_change),
                            number_cell(value.final_change), number_cell(value.rms_difference));
    }
    return text +
           "+- : less the first run, peaks in amount; rms: of the difference over the times of the first run";
}

/// The pictures of the differences of two runs; of more there is none.
std::vector<Drawing> draw_difference(const CompareChoice& choice, const std::vector<ComparedRun>& runs,
                                     const fs::path& folder)
{
    const auto has_frames = [](const ComparedRun& run) {
        return fs::exists(ResultsFolder{run.folder}.particle_series());
    };
    if (runs.size() != 2 || !std::all_of(runs.begin(), runs.end(), has_frames)) return {};
    FrameDifference difference{runs[0].folder,
                               runs[1].folder,
                               runs[1].name + " less " + runs[0].name,
                               {"displacement", "excess_pore_pressure", "shear_strain"},
                               choice.time};
    if (!choice.field.empty()) difference.fields = {choice.field};
    std::string why;
    std::vector<Drawing> drawings = difference_drawings(difference, folder, why);
    if (!why.empty()) std::cerr << "the difference of the frames is not drawn: " << why << std::endl;
    return drawings;
}

} // namespace

ExitCode compare_results(const CompareChoice& choice)
{
    std::vector<std::filesystem::path> folders;
    for (const std::filesystem::path& results : choice.results) folders.push_back(with_histories(results));
    const std::vector<ComparedRun> runs = read_compared_runs(folders);
    const std::vector<ComparedValue> values = compare_runs(runs);
    if (values.empty()) throw InputError("the runs have no column of history.csv or of a probe in common");
    make_output_folder(choice.directory, comparison_file);
    Journal journal;
    journal.keep(choice.directory / comparison_file);
    std::size_t name_width = 0;
    for (const ComparedRun& run : runs) name_width = std::max(name_width, run.name.size());
    journal.say(describe(values, name_width));
    write_comparison(
        choice.directory / "compare.csv", values,
        {"Quicksand " + program_version(),
         "peak: the value that is largest in amount; changes and differences: less the first run"});
    std::vector<Drawing> drawings = comparison_drawings(runs, choice.directory);
    for (Drawing& drawing : draw_difference(choice, runs, choice.directory))
        drawings.push_back(std::move(drawing));
    for (const fs::path& file : draw_pictures(drawings)) journal.say(file.string());
    journal.say((choice.directory / "compare.csv").string());
    return ExitCode::good;
}

} // namespace quicksand
