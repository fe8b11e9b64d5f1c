#include "app/commands/commands.hpp"
#include "app/run/flow_text.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/scene_setup.hpp"
#include "io/files/csv_file.hpp"
#include "io/frames/grid_frame.hpp"
#include "io/frames/particle_frame.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/laws/soil_laws.hpp"
#include "io/results/results_folder.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/base/failure.hpp"
#include "solver/motion/particle_to_grid.hpp"
#include "solver/run/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

constexpr const char* report_file = "stability.txt";
constexpr const char* curve_file = "stability.csv";

void require_strength(const AssembledCase& assembled)
{
    if (has_strength(assembled.problem)) return;
    std::string models;
    for (const SoilLaw& law : soil_laws())
        if (has_strength(law.form)) models += fmt::format("{}\"{}\"", models.empty() ? "" : " or ", law.word);
    throw InputError(
        assembled.scene.file.string() +
        ": no soil of this scene has a strength to reduce\nexpected: a material with model = " + models);
}

/// The search begins at rest: water beyond a curve must be that of the pores already.
void require_still_water(const AssembledCase& assembled)
{
    if (has_pressure(assembled.state.particles)) return; // it balances what is beyond
    const Problem& problem = assembled.problem;
    Diagnostics findings;
    for (const Boundary& boundary : problem.boundaries) {
        if (!has_outer_water(boundary.water)) continue;
        const double factor = outer_factor(boundary.water, 0.0);
        const bool at_rest =
            std::all_of(boundary.segments.begin(), boundary.segments.end(), [&](const Segment& segment) {
                return outer_excess_pressure(problem, boundary, segment.start, factor) == 0.0 &&
                       outer_excess_pressure(problem, boundary, segment.end, factor) == 0.0;
            });
        if (at_rest) continue;
        const SceneBoundary* condition = find_boundary(assembled.scene, boundary.name);
        findings.add(
            error_at(condition != nullptr ? condition->water_place : SourcePlace(), "boundary",
                     fmt::format("the water beyond \"{}\" differs from that in the soil, which stands at "
                                 "{:.5g} m: a slope at rest has one water level",
                                 boundary.name, problem.water->level),
                     "water.level or water.phreatic_line at the height of the water beyond the curve"));
    }
    if (findings.has_errors()) throw_findings(findings, assembled.scene.text);
}

void write_curve(const SafetyFactor& safety, const std::filesystem::path& path)
{
    CsvFile file = CsvFile::begin(
        path,
        {"strength reduction: cohesion and tan(friction_angle) divided by the factor",
         "displacement_m: largest of the slope since it stood first; stands: 1 at rest, 0 failing"},
        {"factor", "displacement_m", "out_of_balance", "stands", "steps"});
    for (const StrengthTrial& trial : safety.trials) {
        file.add_row({csv_number(trial.factor), csv_number(trial.displacement),
                      csv_number(trial.out_of_balance), trial.stands ? "1" : "0",
                      std::to_string(trial.steps)});
    }
    file.flush();
}

void write_failure(const Problem& problem, SafetyFactor& safety, const ResultsFolder& folder)
{
    State state;
    state.particles = std::move(safety.failure);
    VtkSeries(folder.particle_series()).append(particle_frame(problem, state));
    VtkSeries(folder.grid_series())
        .append(grid_frame(problem, nodal_fields(problem, state.particles), state.time));
}

std::string describe_trial(const StrengthTrial& trial)
{
    return fmt::format("  {:>8.4f}  {:<6}  {:>10}  {:>10}  {:>7}", trial.factor,
                       trial.stands ? "stands" : "fails", short_number(1e3 * trial.displacement, 3),
                       short_number(trial.out_of_balance, 2), grouped(trial.steps));
}

std::string describe_result(const SafetyFactor& safety)
{
    if (std::isinf(safety.fails))
        return fmt::format("The factor of safety is more than {:.4g}: the slope still stands.",
                           safety.stands);
    return fmt::format("The factor of safety is {:.3f}: the slope stands at {:.4f} and fails at {:.4f}.",
                       safety.factor, safety.stands, safety.fails);
}

} // namespace

ExitCode assess_stability(const StabilityChoice& choice)
{
    Journal journal;
    SceneSetup setup = set_up_scene(choice.scene, journal);
    AssembledCase& assembled = setup.assembled;
    require_strength(assembled);
    require_still_water(assembled);
    const ResultsFolder folder = prepare_report_folder(
        report_folder(choice.directory, assembled.scene.file, "stability"), report_file, assembled.scene);
    journal.keep(folder.directory / report_file);
    remove_frames(folder); // of a former search: this one may find no failure
    journal.say(fmt::format("Strength reduction of {}: {} particles, cells of {} m",
                            assembled.scene.file.string(),
                            grouped(static_cast<long long>(assembled.state.particles.size())),
                            short_number(assembled.problem.grid.cell_size)));
    if (const std::string flow = summarise_initial_flow(assembled); !flow.empty()) journal.say(flow);
    journal.say("    factor          displ. mm  unbalanced    steps");

    StrengthReductionControls controls;
    controls.tolerance = choice.tolerance;
    controls.seismic_coefficient = choice.seismic_coefficient;
    begin_shaking(assembled.problem, assembled.state);
    SafetyFactor safety =
        safety_factor(assembled.problem, controls, assembled.state,
                      [&](const StrengthTrial& trial) { journal.say(describe_trial(trial)); });
    write_curve(safety, folder.directory / curve_file);
    journal.say(describe_result(safety));
    const std::filesystem::path curve = folder.directory / curve_file;
    if (safety.failure.size() > 0) {
        write_failure(assembled.problem, safety, folder);
        journal.say("How it fails (displacement, shear_strain): " + folder.particle_series().string() +
                    "; displacement against factor: " + curve.string());
    }
    return ExitCode::good;
}

} // namespace quicksand
