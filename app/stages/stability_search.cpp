#include "app/stages/stability_search.hpp"

#include "app/run/flow_text.hpp"
#include "app/run/number_format.hpp"
#include "app/run/stop_signal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/frames/grid_frame.hpp"
#include "io/frames/particle_frame.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/laws/soil_laws.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/base/failure.hpp"
#include "solver/motion/particle_to_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

constexpr const char* curve_file = "stability.csv";

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
    if (safety.stands == 0.0)
        return fmt::format(
            "The factor of safety is less than {:.4f}: the slope stands at no strength of its "
            "soil. Either its pores bear its weight, or forces of the shaking still act."
            "\nhint: residual_strength in a stage of kind = \"stability\" is what sand keeps that "
            "has liquefied",
            safety.fails);
    if (std::isinf(safety.fails))
        return fmt::format("The factor of safety is more than {:.4g}: the slope still stands.",
                           safety.stands);
    return fmt::format("The factor of safety is {:.3f}: the slope stands at {:.4f} and fails at {:.4f}.",
                       safety.factor, safety.stands, safety.fails);
}

/// A coordinate as exact as a box of this size needs it, however far the drawing is from its origin [m].
std::string coordinate_text(double coordinate, double size)
{
    const double ratio = std::abs(coordinate) / size;
    return short_number(coordinate, 3 + (ratio > 1.0 ? static_cast<int>(std::ceil(std::log10(ratio))) : 0));
}

/// Where and how much of the soil moves in the failure that was found; a failure of a few cells hangs on the
/// grid, and may hide that of the slope.
std::string describe_failure(const Problem& problem, const Particles& failure)
{
    constexpr double few_cells = 8.0;
    const MovingSoil moving = moving_soil(failure);
    const double cells = moving.area / (problem.grid.cell_size * problem.grid.cell_size);
    const double size = std::max((moving.high - moving.low).maxCoeff(), problem.grid.cell_size);
    std::string text =
        fmt::format("What moves: {} m2 of soil between ({}, {}) and ({}, {}) m", short_number(moving.area, 3),
                    coordinate_text(moving.low.x(), size), coordinate_text(moving.low.y(), size),
                    coordinate_text(moving.high.x(), size), coordinate_text(moving.high.y(), size));
    if (cells < few_cells)
        text += fmt::format("\n  warning: that is only {} cells, and a failure of so few hangs on the grid\n"
                            "  hint: finer cells; where it is a corner of a slope, a thin region with a "
                            "little more cohesion there shows what the rest bears",
                            short_number(cells, 2));
    return text;
}

} // namespace

void require_strength(const AssembledCase& assembled)
{
    if (has_strength(assembled.problem, assembled.state.particles)) return;
    throw InputError(assembled.scene.file.string() +
                     ": no soil of this scene has a strength to reduce\nexpected: a material with model = " +
                     laws_with_strength());
}

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

void require_standing(const SafetyFactor& safety)
{
    if (safety.stands > 0.0) return;
    FailureRecord record;
    record.phase = "strength reduction";
    record.what = "the body does not come to rest at any strength of its soil";
    record.causes = "a wall is missing among the boundaries; the soil is far too weak for its weight";
    record.step = safety.trials.back().steps;
    throw NumericalError(record);
}

void weaken_liquefied(const ResidualStrength& residual, AssembledCase& assembled, State& state,
                      Journal& journal)
{
    if (!(residual.ratio > 0.0)) return;
    const std::size_t count = give_residual_strength(residual, assembled.problem, state);
    journal.say(fmt::format(
        "{} of {} particles have liquefied (ru of {} or more): their strength is {} times "
        "the vertical effective stress before the shaking",
        grouped(static_cast<long long>(count)), grouped(static_cast<long long>(state.particles.size())),
        short_number(residual.liquefied_ru), short_number(residual.ratio)));
}

SafetyFactor search_stability(const AssembledCase& assembled, const StrengthReductionControls& controls,
                              State& state, const ResultsFolder& folder, Journal& journal)
{
    remove_frames(folder); // of a former search: this one may find no failure
    journal.say(fmt::format("Strength reduction of {}: {} particles, cells of {} m",
                            assembled.scene.file.string(),
                            grouped(static_cast<long long>(state.particles.size())),
                            short_number(assembled.problem.grid.cell_size)));
    if (const std::string flow = summarise_initial_flow(assembled); !flow.empty()) journal.say(flow);
    journal.say("    factor          displ. mm  unbalanced    steps");
    SafetyFactor safety = safety_factor(assembled.problem, controls, state, [&](const StrengthTrial& trial) {
        journal.say(describe_trial(trial));
        if (StopSignal::received()) throw SearchStopped();
    });
    const std::filesystem::path curve = folder.directory / curve_file;
    write_curve(safety, curve);
    journal.say(describe_result(safety));
    if (safety.failure.size() > 0) {
        journal.say(describe_failure(assembled.problem, safety.failure));
        write_failure(assembled.problem, safety, folder);
        journal.say("How it fails (displacement, shear_strain): " + folder.particle_series().string() +
                    "; displacement against factor: " + curve.string());
    }
    return safety;
}

std::optional<double> read_factor_of_safety(const ResultsFolder& folder)
{
    const std::filesystem::path curve = folder.directory / curve_file;
    if (!std::filesystem::exists(curve)) return std::nullopt;
    std::istringstream text(read_text(curve));
    double stands = 0.0;
    std::vector<double> failed; // also before the body came to rest, at factors that it bears
    for (std::string line; std::getline(text, line);) {
        const CsvRow cells = csv_cells(line);
        const double factor = csv_value(cells.front());
        if (cells.size() < 4 || std::isnan(factor)) continue; // comments and names
        if (cells[3] == "1")
            stands = std::max(stands, factor);
        else
            failed.push_back(factor);
    }
    double fails = std::numeric_limits<double>::infinity();
    for (const double factor : failed)
        if (factor > stands) fails = std::min(fails, factor);
    constexpr double scale = 1e4; // digits beyond the width of any bracket are of no use
    return std::isfinite(fails) && stands > 0.0 ? std::round(scale * 0.5 * (stands + fails)) / scale : stands;
}

} // namespace quicksand
