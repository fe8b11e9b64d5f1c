#include "app/bench/bench_runs.hpp"
#include "app/bench/benchmarks.hpp"
#include "app/bench/history_error.hpp"
#include "app/machine/machine.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/scene_setup.hpp"
#include "app/run/step_cost.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/pictures/line_plot.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// A run on one grid.
struct GridRun {
    Setting setting;
    double cell_size = 0.0;     // [m]
    int particles_per_cell = 0; // along each axis; 0 where the drawing's mesh gives them [-]
    SettingRun outcome = {};
    fs::path results = {};
    std::vector<ProbeHistory> probes = {};
};

std::string length_text(double metres)
{
    return metres < 0.1 ? fmt::format("{:.4g} mm", 1e3 * metres) : fmt::format("{:.4g} m", metres);
}

/// Cells of twice, once, two thirds and half the scene's size, then other numbers of particles in the
/// scene's.
std::vector<GridRun> planned_runs(const Scene& scene, const BackgroundGrid& grid)
{
    const auto* lattice = std::get_if<LatticeSampling>(&scene.sampling);
    const int own = lattice != nullptr ? lattice->per_cell_x : 0;
    const auto run_on = [&](double cell_size, int count) {
        GridRun run{{length_text(cell_size), on_cells_of(cell_size, grid)}, cell_size, count};
        if (count > 0) run.setting.name += fmt::format(", {} x {}", count, count);
        if (count != own)
            run.setting.overrides.push_back(fmt::format("sampling.particles_per_cell=[{},{}]", count, count));
        return run;
    };
    std::vector<GridRun> runs;
    for (const double factor : {2.0, 1.0, 2.0 / 3.0, 0.5})
        runs.push_back(run_on(factor * grid.cell_size, own));
    for (const int count : {2, 3, 4})
        if (lattice != nullptr && count != own) runs.push_back(run_on(grid.cell_size, count));
    return runs;
}

/// Whether the run reached its end; why not is told.
bool execute(const std::string& scene, const BenchChoice& choice, const fs::path& folder, Journal& journal,
             GridRun& run)
{
    run.results = folder / file_name_of(run.setting.name);
    journal.say('\n' + run.setting.name);
    try {
        run.outcome = run_setting(scene, run.setting, choice, run.results);
    } catch (const InputError& error) {
        const std::string text = error.what();
        journal.say("  left out: " + text.substr(0, text.find('\n')));
        return false;
    }
    if (run.outcome.end == SessionEnd::failed)
        journal.say("  left out: the run failed; see " + run.results.string());
    if (run.outcome.end != SessionEnd::finished) return false;
    run.probes = read_probe_histories(run.results);
    return true;
}

/// Mean over the last fifth of the run, NaN where there is no value.
double late_mean(const std::vector<double>& time, const std::vector<double>& values)
{
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < std::min(time.size(), values.size()); ++k) {
        if (time[k] < 0.8 * time.back() || std::isnan(values[k])) continue;
        sum += values[k];
        count += 1.0;
    }
    return count > 0.0 ? sum / count : NAN;
}

/// When a pressure ratio is first reached; NaN when it is not.
double time_of_ratio(double wanted, const PictureTable& table)
{
    const std::vector<double>*time = table.find("time_s"), *ratio = table.find("ru");
    if (ratio == nullptr) return NAN;
    for (std::size_t k = 0; k < ratio->size(); ++k)
        if ((*ratio)[k] >= wanted) return (*time)[k];
    return NAN;
}

/// One answer of a run at a probe.
struct Answer {
    std::string probe, quantity;
    double value = 0.0;
};

/// What engineers ask a run: late pressures and displacements, and when the soil liquefied.
std::vector<Answer> answers_of(const GridRun& run)
{
    std::vector<Answer> answers;
    for (const ProbeHistory& each : run.probes) {
        for (const ComparedQuantity& quantity : compared_quantities) {
            const std::vector<double>* values = each.table.find(quantity.column);
            if (values == nullptr) continue;
            const double mean = quantity.scale * late_mean(*each.table.find("time_s"), *values);
            answers.push_back(
                {each.probe, fmt::format("{}, late mean [{}]", quantity.name, quantity.unit), mean});
        }
        constexpr double liquefied = 0.95;
        if (each.table.find("ru") != nullptr)
            answers.push_back({each.probe, "time of ru = 0.95 [s]", time_of_ratio(liquefied, each.table)});
    }
    return answers;
}

std::string table_of(const std::vector<GridRun>& runs)
{
    std::string text = fmt::format("\n{:<52}", "");
    for (const GridRun& run : runs) text += fmt::format("{:>16}", run.setting.name);
    text += fmt::format("\n{:<52}", "run time");
    for (const GridRun& run : runs) text += fmt::format("{:>16}", duration_text(run.outcome.seconds));
    std::vector<std::vector<Answer>> columns;
    for (const GridRun& run : runs) columns.push_back(answers_of(run));
    for (std::size_t row = 0; row < columns.front().size(); ++row) {
        if (std::all_of(columns.begin(), columns.end(),
                        [&](const std::vector<Answer>& answers) { return std::isnan(answers[row].value); }))
            continue;
        const Answer& first = columns.front()[row];
        text += fmt::format("\n{:<52}", first.probe + ": " + first.quantity);
        for (const auto& answers : columns)
            text += fmt::format("{:>16}", std::isnan(answers[row].value) ? std::string("-")
                                                                         : short_number(answers[row].value));
    }
    return text;
}

std::string grid_csv(const std::vector<GridRun>& runs)
{
    std::string text = "# " + machine_text() +
                       "\n# late mean: over the last fifth of the run\n"
                       "setting,cell_size_m,particles_per_cell_per_axis,seconds,probe,quantity,value\n";
    for (const GridRun& run : runs)
        for (const Answer& answer : answers_of(run))
            text += fmt::format("{},{:.6g},{},{:.6g},{},{},{}\n", csv_text(run.setting.name), run.cell_size,
                                run.particles_per_cell, run.outcome.seconds, csv_text(answer.probe),
                                csv_text(answer.quantity), csv_number(answer.value));
    return text;
}

/// The histories of a quantity in all runs, a panel for each probe; the key tells the run time.
LinePlot histories_of(const ComparedQuantity& quantity, const std::string& title,
                      const std::vector<GridRun>& runs)
{
    LinePlot plot;
    plot.title = "On other grids: " + std::string(quantity.name);
    plot.note = title;
    for (const ProbeHistory& probe : runs.front().probes) {
        PlotPanel panel;
        panel.x_label = "time [s]";
        panel.y_label = fmt::format("{}: {} [{}]", probe.probe, quantity.name, quantity.unit);
        panel.key = KeyPlace::beside;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const PictureTable* same = find_probe(runs[k].probes, probe.probe);
            if (same == nullptr) continue;
            const std::vector<double>* values = same->find(quantity.column);
            if (values == nullptr) continue;
            PlotCurve curve;
            if (plot.panels.empty())
                curve.name = runs[k].setting.name + ": " + duration_text(runs[k].outcome.seconds);
            curve.colour = curve_colour(k, runs.size());
            curve.x = *same->find("time_s");
            for (const double value : *values) curve.y.push_back(quantity.scale * value);
            panel.curves.push_back(std::move(curve));
        }
        if (!panel.curves.empty()) plot.panels.push_back(std::move(panel));
    }
    return plot;
}

void report(const std::string& title, const std::vector<GridRun>& runs, const fs::path& folder,
            Journal& journal)
{
    journal.say(table_of(runs));
    const auto finest = std::min_element(runs.begin(), runs.end(), [](const GridRun& a, const GridRun& b) {
        return a.cell_size < b.cell_size;
    });
    journal.say("\nRoot of the mean square difference from " + finest->setting.name + ", over its range");
    for (const GridRun& run : runs) {
        if (&run == &*finest) continue;
        for (const HistoryError& error : history_errors(run.probes, finest->probes))
            journal.say(run.setting.name + ": " + text_of(error));
    }
    write_atomically(folder / "grid.csv", grid_csv(runs));
    std::vector<Drawing> drawings;
    for (const ComparedQuantity& quantity : compared_quantities) {
        const LinePlot plot = histories_of(quantity, title, runs);
        if (!plot.panels.empty())
            drawings.push_back(plot_drawing(plot, folder / ("grid_" + file_name_of(quantity.name) + ".png")));
    }
    draw_pictures(drawings);
    journal.say("\nTable and figures: " + folder.string());
}

/// Run the plan and report on the runs that reach their end.
ExitCode compare(const SceneSetup& setup, const fs::path& scene, const BenchChoice& choice,
                 const fs::path& folder, Journal& journal)
{
    std::vector<GridRun> done;
    bool went_bad = false;
    for (GridRun& run : planned_runs(setup.assembled.scene, setup.assembled.problem.grid)) {
        const bool reached = execute(scene.string(), choice, folder, journal, run);
        if (run.outcome.end == SessionEnd::stopped) {
            journal.say("\nStopped on request. The runs before are in " + folder.string());
            return ExitCode::good;
        }
        went_bad = went_bad || run.outcome.end == SessionEnd::failed;
        if (reached) done.push_back(std::move(run));
    }
    if (done.empty()) {
        journal.complain("none of the runs reached its end; see " + folder.string());
        return went_bad ? ExitCode::numerical : ExitCode::input;
    }
    report(setup.assembled.scene.title, done, folder, journal);
    return ExitCode::good;
}

} // namespace

ExitCode measure_grids(const BenchChoice& choice)
{
    Journal journal;
    const fs::path scene = find_scene_file(only_scene(choice));
    const fs::path folder = choice.directory / scene_name(scene);
    fs::create_directories(folder);
    journal.keep(folder / "grid.txt");
    journal.say(machine_text());
    SceneChoice words;
    words.scene = scene;
    words.overrides = choice.overrides;
    const SceneSetup setup = set_up_scene(words, journal);
    return compare(setup, scene, choice, folder, journal);
}

} // namespace quicksand
