#include "app/run/plan.hpp"

#include "app/run/motion_text.hpp"
#include "app/run/number_format.hpp"
#include "io/laws/soil_laws.hpp"
#include "io/results/output_observers.hpp"
#include "solver/base/threads.hpp"
#include "solver/measure/monitors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <variant>

namespace quicksand {

namespace {

constexpr double cells_per_wavelength = 10.0; // of a shear wave that the grid carries well [-]

std::string describe_waves(const Material& material, const WaveSpeeds& waves, const Problem& problem)
{
    std::string text = fmt::format("  {:<25} ", material.name);
    if (!material.has_pores) text += "solid without pores, ";
    if (problem.water && is_wet(material)) {
        text += fmt::format("fast P {:.0f}, undrained P {:.0f}, slow P {:.0f}, ", waves.fast, waves.undrained,
                            waves.slow);
    }
    text +=
        fmt::format("skeleton P {:.0f}, shear {:.0f} m/s; waves up to {:.0f} Hz are resolved", waves.skeleton,
                    waves.shear, waves.shear / (cells_per_wavelength * problem.grid.cell_size));
    if (const auto damping = vibration_damping_of(material.law))
        text += fmt::format(
            ", damped by {:.2g} % from {:.3g} to {:.3g} Hz, {:.2g} % softer under loads that last",
            100.0 * damping->ratio, damping->lowest, damping->highest, 100.0 * (1.0 - damping->relaxed));
    return text + "\n";
}

/// The word of a law whose soil is free of stress as drawn; "" without any.
std::string_view law_without_stress(const Problem& problem)
{
    for (const Material& material : problem.materials)
        if (!bears_stress_as_drawn(material.law)) return soil_law(material.law).word;
    return "";
}

} // namespace

std::string describe_laws(const AssembledCase& assembled)
{
    std::string text;
    for (const SceneMaterial& material : assembled.scene.materials) {
        const SoilLaw& law = soil_law(material.material.law);
        if (law.describe != nullptr) text += law.describe(material.material, assembled.scene.k0);
    }
    return text.empty() ? text : "Soil laws (their parameters are listed above)\n" + text;
}

namespace {

std::string warn_of_coarse_rows(const Scene& scene)
{
    return scene.probes.empty() ? "" : warn_of_coarse_rows(scene.base_motion, scene.output.probe_interval);
}

} // namespace

std::vector<std::string> warnings_of_motion(const Scene& scene)
{
    std::vector<std::string> warnings = {warn_of_drift(scene.base_motion), warn_of_coarse_rows(scene)};
    std::erase(warnings, "");
    return warnings;
}

std::string describe_motion(const AssembledCase& assembled)
{
    const BaseMotion& motion = assembled.scene.base_motion;
    const std::string rows = warn_of_coarse_rows(assembled.scene);
    const std::string end = rows.empty() ? "" : "  " + rows + '\n';
    if (const auto* record = std::get_if<SampledMotion>(&motion))
        return "Shaking\n" + describe_motion_measures(*record, "motion.baseline") + end;
    if (const auto* sine = std::get_if<SineMotion>(&motion)) return "Shaking\n" + describe_sine(*sine) + end;
    return "";
}

std::string describe_scene_keys(const SceneSetup& setup)
{
    std::size_t path_width = 0, value_width = 0;
    for (const ResolvedKey& key : setup.keys) {
        path_width = std::max(path_width, key.path.size());
        value_width =
            std::max(value_width, std::min<std::size_t>(key.value.size() + key.unit.size() + 1, 28));
    }
    std::string text = "Scene " + setup.assembled.scene.file.string() + ", in SI units\n";
    for (const ResolvedKey& key : setup.keys) {
        text += fmt::format("  {:<{}}  {:<{}}  {}\n", key.path, path_width,
                            key.value + (key.unit.empty() ? "" : " ") + key.unit, value_width,
                            key.given ? "given" : "default");
    }
    return text;
}

std::string describe_soil(const AssembledCase& assembled)
{
    const Problem& problem = assembled.problem;
    std::string text = fmt::format("Soil\n  {:<16}{:>12}{:>14}{:>12}{:>20}\n", "region", "area m2",
                                   "area error", "particles", "of them cut");
    std::size_t cut = 0;
    for (std::size_t r = 0; r < assembled.sampling.regions.size(); ++r) {
        const RegionSampling& region = assembled.sampling.regions[r];
        if (region.particles == 0) {
            text +=
                fmt::format("  {:<16}{:>12.6g}  without soil here\n", problem.region_names[r], region.area);
            continue;
        }
        text += fmt::format("  {:<16}{:>12.6g}{:>14.2e}{:>12}{:>20}\n", problem.region_names[r], region.area,
                            region.area_error, grouped(static_cast<long long>(region.particles)),
                            grouped(static_cast<long long>(region.cut)));
        cut += region.cut;
    }
    const Monitors sums = monitor(problem, assembled.state, {});
    const BackgroundGrid& grid = problem.grid;
    const std::string of_them =
        cut > 0 ? fmt::format(", of them {} cut at outlines or water,", grouped(static_cast<long long>(cut)))
                : "";
    text +=
        fmt::format("  {} particles{} in {} x {} = {} cells of {} m; {:.2f} per occupied cell ({} cells)\n",
                    grouped(static_cast<long long>(assembled.state.particles.size())), of_them, grid.cells_x,
                    grid.cells_y, grouped(static_cast<long long>(grid.cells_x) * grid.cells_y),
                    short_number(grid.cell_size), assembled.sampling.particles_per_cell,
                    grouped(static_cast<long long>(assembled.sampling.occupied_cells)));
    for (const std::string& reason : assembled.grid_reasons)
        text +=
            fmt::format("  {:<16}{}\n", &reason == &assembled.grid_reasons.front() ? "the grid" : "", reason);
    text += fmt::format("  mass of the grains {} kg/m, of the water {} kg/m\n",
                        short_number(sums.mass_solid, 6), short_number(sums.mass_fluid, 6));
    return text;
}

namespace {

/// "0.5" or "0.5 to 1"
std::string thickness_text(const InterfaceLayer& layer)
{
    const std::string largest = short_number(layer.thickness);
    return layer.least_thickness < layer.thickness ? short_number(layer.least_thickness) + " to " + largest
                                                   : largest;
}

} // namespace

std::string describe_interfaces(const AssembledCase& assembled)
{
    std::string text;
    for (const InterfaceLayer& layer : assembled.interfaces) {
        text += fmt::format("  {:<16}{} particles of {} within {} m of {} slide at {:.3g} deg", layer.name,
                            grouped(static_cast<long long>(layer.particles)), layer.sliding,
                            thickness_text(layer), layer.beside,
                            std::atan(layer.strength.friction) * 180.0 / std::numbers::pi);
        if (layer.strength.cohesion > 0.0)
            text += fmt::format(" and {} Pa", short_number(layer.strength.cohesion));
        text += layer.is_that_of_soil ? ", the strength of the soil itself along a plane\n" : "\n";
    }
    return text.empty() ? text : "Interfaces\n" + text;
}

std::string describe_initial_state(const AssembledCase& assembled)
{
    const double residual = out_of_balance(assembled.problem, assembled.state);
    std::string text = "Initial state\n";
    const auto& materials = assembled.problem.materials;
    std::size_t above = 0;
    for (const std::int32_t m : assembled.state.particles.material)
        above += materials[static_cast<std::size_t>(m)].saturated ? 0 : 1;
    if (above > 0) {
        text += fmt::format("  {} particles lie above the phreatic line and carry no pore water\n",
                            grouped(static_cast<long long>(above)));
    }
    text += fmt::format("  out-of-balance force {} of the {}: ", short_number(residual, 2),
                        assembled.problem.gravity > 0.0 ? "weight" : "internal forces");
    const auto& controls = assembled.scene.relaxation;
    const double tolerance = controls.value_or(RelaxationControls{}).tolerance;
    if (residual <= tolerance) return text + "the run starts in equilibrium\n";
    if (controls) return text + "the soil settles before the run\n";
    text += "the run does not start in equilibrium; ";
    const std::string_view law = law_without_stress(assembled.problem);
    return text +
           (law.empty()
                ? "a table [relaxation] lets the soil settle\n"
                : fmt::format("soil of {} is free of stress as drawn, and its weight acts at once\n", law));
}

std::string describe_time_step(const AssembledCase& assembled, const TimeStep& step)
{
    const Problem& problem = assembled.problem;
    std::string text = "Waves, where the soil is stiffest\n";
    if (problem.water && problem.water->flow != WaterFlow::drained)
        text += fmt::format("  the water's bulk modulus, with its air, is {} Pa\n",
                            short_number(problem.water->bulk_modulus));
    Problem undamped_form = problem; // whose waves are those at the middle of the bands of damping
    for (Material& material : undamped_form.materials) material.law = undamped(material.law);
    const std::vector<WaveSpeeds> waves = fastest_waves(undamped_form, assembled.state.particles);
    for (std::size_t m = 0; m < waves.size(); ++m) {
        text += describe_waves(problem.materials[m], waves[m], problem);
    }
    text += fmt::format("Time step\n  {} s, limited by the {}{}\n", short_number(step.dt),
                        name_of(step.limiter), step.material.empty() ? "" : " in " + step.material);
    if (step.replaced > 0.0)
        text +=
            fmt::format("  {} steps at first, which cost less than the implicit ones of {} s that accuracy "
                        "allows\n",
                        name_of(step.scheme), short_number(step.replaced));
    const bool is_about_sound =
        water_flow(problem) == WaterFlow::coupled && problem.scheme == TimeScheme::explicit_steps;
    if (!assembled.scene.scheme)
        text += fmt::format("  {} steps, {}\n", name_of(problem.scheme),
                            is_about_sound ? "for so short a run is about sound in the water"
                                           : "which suit the scene and take the least time");
    if (assembled.scene.relaxation) {
        const TimeStep settling =
            stable_relaxation_step(settling_problem(problem), assembled.state.particles);
        text += fmt::format("  {} s while settling\n", short_number(settling.dt));
    }
    return text;
}

namespace {

std::string settling_line(const RelaxationForecast& forecast)
{
    return fmt::format(
        "  settling   about {} steps of {} ms{}\n", grouped(forecast.steps),
        short_number(1e3 * forecast.step_seconds),
        forecast.reliable ? "" : "; the soil did not settle in the trial, so this is the limit max_steps");
}

} // namespace

std::string describe_settling_cost(const RelaxationForecast& forecast)
{
    return "Cost\n" + settling_line(forecast) +
           fmt::format("  run time   about {}\n", duration_text(forecast.seconds()));
}

std::string describe_cost(const Forecast& forecast)
{
    std::string text = "Cost\n";
    const RelaxationForecast& relaxation = forecast.relaxation;
    if (relaxation.needed) text += settling_line(relaxation);
    text += fmt::format("  steps      {} of {} ms, measured with {}\n", grouped(forecast.steps),
                        short_number(1e3 * forecast.step_seconds), threads_text(thread_count()));
    text += fmt::format("  run time   about {}: {}steps {}, output {}\n", duration_text(forecast.seconds()),
                        relaxation.needed ? "settling " + duration_text(relaxation.seconds()) + ", " : "",
                        duration_text(forecast.shaking_seconds()), duration_text(forecast.output.seconds));
    if (forecast.output.background_seconds > 0.0)
        text += fmt::format(
            "             frames are written in the background, in {}{}\n",
            duration_text(forecast.output.background_seconds),
            forecast.output.has_own_core ? "" : ", which adds to the run time: all cores run the steps");
    text += fmt::format("  memory     {}\n", bytes_text(forecast.memory));
    text += fmt::format("  disk       {} for {} frames, probes and one checkpoint\n",
                        bytes_text(forecast.output.bytes), grouped(forecast.output.frames));
    return text;
}

std::string describe_column(const SoilColumn& column)
{
    const std::string rows =
        column.row_length > 1 ? fmt::format(", and one particle of {} in each row", column.row_length) : "";
    return fmt::format(
        "One column of {} is computed{}: the soil repeats from cell to cell between tied sides. "
        "{} particles stand for {}",
        column.columns, rows, grouped(static_cast<long long>(column.state.particles.size())),
        grouped(static_cast<long long>(column.source.size())));
}

std::string describe_left_out(const Scene& scene, const StagedRun& run, const std::string& start)
{
    std::string text;
    const auto leave_out = [&](bool condition, const std::string& line) {
        if (condition) text += std::string("  ") + line + '\n';
    };
    leave_out(!scene.water,
              "pore water: dry soil moves as one phase and its particles carry no arrays for water");
    leave_out(
        scene.water && scene.water->flow == WaterFlow::undrained,
        "relative flow: undrained, grains and water have one velocity, from which the pressure follows");
    leave_out(scene.water && scene.water->flow == WaterFlow::drained,
              "excess pore pressure: drained, the water has weight, moves with the grains and stays without "
              "excess");
    leave_out(scene.strain == StrainForm::small,
              "the update of domains, volumes and weights: small strain, on the drawn shape");
    leave_out(run.problem().scheme == TimeScheme::semi_implicit,
              "steps limited by sound in water: the pore pressure is implicit");
    leave_out(run.problem().scheme == TimeScheme::implicit,
              "steps limited by waves alone: implicit ones follow the motion, where they cost less");
    leave_out(!scene.relaxation, "settling: the run starts from " + start);
    leave_out(std::holds_alternative<NoMotion>(scene.base_motion), "shaking: the base is at rest");
    leave_out(std::holds_alternative<LatticeSampling>(scene.sampling),
              "meshing: the particles lie on a lattice");
    leave_out(scene.probes.empty(), "probes: none are named");
    if (const SoilColumn* column = run.column()) {
        text += fmt::format("  {} of {} columns of cells: the soil repeats from cell to cell between tied "
                            "sides, and one stands for all\n",
                            column->columns - 1, column->columns);
        leave_out(column->row_length > 1,
                  fmt::format("{} of {} particles of each row of a cell: nothing varies "
                              "along it, and one stands for all",
                              column->row_length - 1, column->row_length));
    }
    if (!text.empty()) text = "Not needed, so left out\n" + text;
    if (run.obstacle().empty()) return text;
    return text + "All columns of cells between the tied sides are computed: " + run.obstacle() + '\n';
}

} // namespace quicksand
