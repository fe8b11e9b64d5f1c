#include "app/bench/bench_runs.hpp"
#include "app/bench/benchmarks.hpp"
#include "app/bench/history_error.hpp"
#include "app/machine/machine.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/scene_setup.hpp"
#include "app/verify/verification_runs.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/pictures/line_plot.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace quicksand {

namespace {

/// One problem on one grid with one setting.
struct WorkPoint {
    std::string problem, setting;
    int cells = 0;
    double error = 0.0;   // the largest over the quantities of the study [-]
    double seconds = 0.0; // wall time on one thread
};

/// Those that a problem does not allow are left out.
std::vector<Setting> settings()
{
    const auto particles = [](int count) {
        return fmt::format("sampling.particles_per_cell=[{},{}]", count, count);
    };
    const std::string implicit = "analysis.scheme=\"semi_implicit\"", half = "analysis.step_share=0.5";
    return {{"as the scene says", {}},
            {"4 particles per cell", {particles(2)}},
            {"16 particles per cell", {particles(4)}},
            {"linear", {"analysis.interpolation=\"linear\""}},
            {"GIMP", {"analysis.interpolation=\"gimp\""}},
            {"cpGIMP", {"analysis.interpolation=\"cpgimp\""}},
            {"CPDI2", {"analysis.interpolation=\"cpdi2\""}},
            {"half steps", {half}},
            {"semi-implicit", {implicit}},
            {"semi-implicit, half steps", {implicit, half}}};
}

double largest_error(const VerificationRun& run)
{
    double largest = 0.0;
    for (const StudyError& error : run.errors) largest = std::max(largest, error.error);
    return largest;
}

/// Why a setting cannot be had, in one line; "" when it could.
std::string measure_setting(const std::string& problem, const Setting& setting, const BenchChoice& choice,
                            Journal& journal, std::vector<WorkPoint>& points)
{
    VerifyChoice verify;
    verify.problems = {problem};
    verify.overrides = choice.overrides;
    verify.overrides.insert(verify.overrides.end(), setting.overrides.begin(), setting.overrides.end());
    try {
        std::vector<VerificationRun> runs = prepare_runs(verify);
        execute_runs(1, runs, journal);
        for (const VerificationRun& run : runs) {
            if (!run.failure)
                points.push_back({run.problem, setting.name, run.cells, largest_error(run), run.seconds});
        }
    } catch (const InputError& error) {
        const std::string text = error.what();
        return text.substr(0, text.find('\n'));
    }
    return "";
}

/// Of the steps alone: a scene's own answer is not known, only what smaller explicit steps give.
std::vector<Setting> step_settings()
{
    const std::string semi_implicit = "analysis.scheme=\"semi_implicit\"",
                      by_steps = "analysis.scheme=\"explicit\"", half = "analysis.step_share=0.5",
                      quarter = "analysis.step_share=0.25";
    return {{"explicit", {by_steps}},
            {"semi-implicit", {semi_implicit}},
            {"semi-implicit, half steps", {semi_implicit, half}},
            {"semi-implicit, quarter steps", {semi_implicit, quarter}}};
}

/// What was measured of one problem.
struct Measurement {
    SessionEnd end = SessionEnd::finished; // of the run without which there is nothing to measure
    std::vector<WorkPoint> points;
};

/// The probes of a scene against an explicit run with a fifth of the step. A setting whose run goes bad is
/// told and left out.
Measurement measure_scene(const std::string& scene, const BenchChoice& choice, Journal& journal)
{
    const std::string name = scene_name(find_scene_file(scene));
    const std::filesystem::path folder = choice.directory / name;
    const Setting fine = {"explicit, a fifth of the step",
                          {"analysis.scheme=\"explicit\"", "analysis.step_share=0.2"}};
    Measurement measured;
    measured.end = run_setting(scene, fine, choice, folder / "reference").end;
    if (measured.end == SessionEnd::failed)
        journal.complain(name + ": left out: the explicit run to compare with failed");
    if (measured.end != SessionEnd::finished) return measured;
    const std::vector<ProbeHistory> reference = read_probe_histories(folder / "reference");
    for (const Setting& setting : step_settings()) {
        const std::string directory = file_name_of(setting.name);
        const SettingRun run = run_setting(scene, setting, choice, folder / directory);
        if (run.end == SessionEnd::stopped) return {run.end, {}};
        if (run.end == SessionEnd::failed) {
            journal.say(setting.name + ": left out: its run failed; see " + (folder / directory).string());
            continue;
        }
        for (const HistoryError& each : history_errors(read_probe_histories(folder / directory), reference)) {
            journal.say(setting.name + ": " + text_of(each));
            measured.points.push_back(
                {name + ", " + each.quantity, setting.name, 0, each.largest(), run.seconds});
        }
    }
    return measured;
}

/// A problem of `verify` with all settings.
Measurement measure_problem(const std::string& problem, const BenchChoice& choice, Journal& journal)
{
    Measurement measured;
    for (const Setting& setting : settings()) {
        journal.say(fmt::format("\n{}, {}", problem, setting.name));
        const std::string refusal = measure_setting(problem, setting, choice, journal, measured.points);
        if (!refusal.empty()) journal.say("  left out: " + refusal);
    }
    return measured;
}

bool is_a_run(const std::string& word)
{
    return std::filesystem::exists(word) && !read_scene_file(find_scene_file(word), {}).scene.verification;
}

LinePlot work_plot(const std::string& problem, const std::vector<WorkPoint>& points)
{
    LinePlot plot;
    plot.title = problem + ": error against run time";
    plot.note = "each curve goes through the grids; lower left is better";
    plot.arrangement = PlotArrangement::side_by_side;
    PlotPanel panel;
    panel.x_label = "run time on one thread [s]";
    panel.y_label = "largest relative error";
    panel.key = KeyPlace::beside;
    panel.x_scale = AxisScale::logarithmic;
    panel.y_scale = AxisScale::logarithmic;
    std::vector<std::string> names;
    for (const WorkPoint& point : points) {
        if (names.empty() || names.back() != point.setting) names.push_back(point.setting);
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        PlotCurve curve;
        curve.name = names[k];
        curve.colour = curve_colour(k, names.size());
        curve.style = CurveStyle::line_with_points;
        for (const WorkPoint& point : points) {
            if (point.setting != names[k] || !(point.error > 0.0)) continue;
            curve.x.push_back(point.seconds);
            curve.y.push_back(point.error);
        }
        if (!curve.x.empty()) panel.curves.push_back(std::move(curve));
    }
    plot.panels = {std::move(panel)};
    return plot;
}

/// The cheapest run whose error is at most `wanted`.
std::string recommendation(const std::vector<WorkPoint>& points, double wanted)
{
    const WorkPoint* best = nullptr;
    for (const WorkPoint& point : points) {
        if (point.error <= wanted && (best == nullptr || point.seconds < best->seconds)) best = &point;
    }
    const std::string aim = fmt::format("  for {:.3g} % error: ", 100.0 * wanted);
    if (best == nullptr) return aim + "none of the runs";
    const std::string grid = best->cells > 0 ? fmt::format(", {} cells", best->cells) : "";
    return aim + fmt::format("{}{}: {:.2g} % in {}", best->setting, grid, 100.0 * best->error,
                             duration_text(best->seconds));
}

/// The points apart that are of different problems, or of different quantities of a scene.
std::vector<std::vector<WorkPoint>> by_problem(const std::vector<WorkPoint>& points)
{
    std::vector<std::vector<WorkPoint>> parts;
    for (const WorkPoint& point : points) {
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const std::vector<WorkPoint>& each) {
            return each.front().problem == point.problem;
        });
        if (part == parts.end()) {
            parts.push_back({point});
        } else {
            part->push_back(point);
        }
    }
    return parts;
}

std::string error_csv(const std::vector<WorkPoint>& points)
{
    std::string text = "# " + machine_text() + "\nproblem,setting,cells,largest_error,seconds\n";
    for (const WorkPoint& point : points)
        text += fmt::format("{},{},{},{:.6g},{:.6g}\n", csv_text(point.problem), csv_text(point.setting),
                            point.cells, point.error, point.seconds);
    return text;
}

ExitCode measure_all(const BenchChoice& choice, Journal& journal)
{
    std::vector<std::string> problems = choice.words;
    if (problems.empty())
        problems = {"terzaghi", "periodic_column_2", "transient_column", "vortex", "cantilever"};
    std::vector<WorkPoint> all;
    std::string advice;
    ExitCode code = ExitCode::good;
    for (const std::string& problem : problems) {
        const Measurement measured = is_a_run(problem) ? measure_scene(problem, choice, journal)
                                                       : measure_problem(problem, choice, journal);
        if (measured.end == SessionEnd::stopped) {
            journal.say("\nStopped on request. What was measured before is in " + choice.directory.string());
            return ExitCode::good;
        }
        if (measured.end == SessionEnd::failed) code = ExitCode::numerical;
        if (measured.points.empty()) continue;
        for (const std::vector<WorkPoint>& part : by_problem(measured.points)) {
            const std::string& name = part.front().problem;
            const std::filesystem::path png = choice.directory / ("error_" + file_name_of(name) + ".png");
            draw_pictures({plot_drawing(work_plot(name, part), png)});
            advice += '\n' + name;
            for (const double wanted : {0.05, 0.01, 0.001}) advice += '\n' + recommendation(part, wanted);
        }
        all.insert(all.end(), measured.points.begin(), measured.points.end());
        write_atomically(choice.directory / "error.csv", error_csv(all)); // what is done is not lost
    }
    journal.say("\nThe cheapest settings" + advice);
    journal.say("\nTable and figures: " + choice.directory.string());
    return code;
}

} // namespace

ExitCode measure_errors(const BenchChoice& choice)
{
    Journal journal;
    std::filesystem::create_directories(choice.directory);
    journal.keep(choice.directory / "error.txt");
    journal.say(machine_text());
    return measure_all(choice, journal);
}

} // namespace quicksand
