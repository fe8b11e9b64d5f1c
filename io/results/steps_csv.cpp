#include "io/results/steps_csv.hpp"

#include "solver/measure/point_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace quicksand {

namespace {

constexpr std::string_view max_ru = "max_ru";

constexpr std::array all_columns = {
    DocumentedName{"time_s", "time since the shaking began: the end of a step"},
    DocumentedName{"step", "steps since the shaking began or the run was resumed"},
    DocumentedName{"dt_s", "the last time step that was not shortened to hit an output time"},
    DocumentedName{"dt_limiter", "what limits it"},
    DocumentedName{"dt_material", "the material that does"},
    DocumentedName{
        "dt_scheme",
        "the scheme by which it is taken; a run of implicit steps takes those that waves limit where "
        "they cost less"},
    DocumentedName{"dt_replaced_s",
                   "the implicit step in whose place one that waves limit is taken; empty elsewhere"},
    DocumentedName{"wall_s", "time since the run began, over all its processes"},
    DocumentedName{"eta_s", "estimate of the time that is left"},
    DocumentedName{"mass_kg", "mass of both phases"},
    DocumentedName{"mass_error", "its change since the first row, relative"},
    DocumentedName{"momentum_x_N_s", "horizontal momentum of both phases, relative to the base"},
    DocumentedName{"momentum_y_N_s", "vertical momentum of both phases, upward"},
    DocumentedName{"kinetic_J", "kinetic energy of both phases"},
    DocumentedName{"max_velocity_m_s", "largest velocity of the grains"},
    DocumentedName{max_ru, "largest excess pore pressure / initial vertical effective stress, with water"},
};

/// Those of the scene.
std::vector<DocumentedName> columns_of(const Problem& problem)
{
    std::vector<DocumentedName> found(all_columns.begin(), all_columns.end());
    if (!problem.water) std::erase_if(found, [](const auto& column) { return column.name == max_ru; });
    return found;
}

/// A name as a cell: what would break the row or the line is replaced, since rows are read by their commas.
std::string csv_cell(std::string name)
{
    const auto breaks = [](char letter) {
        return letter == ',' || letter == '"' || static_cast<unsigned char>(letter) < 0x20U;
    };
    std::replace_if(name.begin(), name.end(), breaks, '_');
    return name;
}

CsvFile open_steps_file(const Problem& problem, double time, const RunLabel& label,
                        const std::filesystem::path& path, bool resume)
{
    std::vector<std::string> comments = run_comments(label);
    comments.emplace_back("sums are per metre of thickness");
    std::vector<std::string> names;
    for (const DocumentedName& column : columns_of(problem)) {
        names.emplace_back(column.name);
        comments.push_back(fmt::format("{}: {}", column.name, column.meaning));
    }
    return resume ? CsvFile::resume(path, comments, names, time) : CsvFile::begin(path, comments, names);
}

} // namespace

std::vector<DocumentedName> step_columns()
{
    return {all_columns.begin(), all_columns.end()};
}

StepsWriter::StepsWriter(const Scene& scene, const Problem& problem, const State& state,
                         const RunLabel& label, const std::filesystem::path& path, bool resume)
    : clock_(scene.output.history_interval, scene.end_time),
      file_(open_steps_file(problem, state.time, label, path, resume)), start_time_(state.time),
      end_time_(scene.end_time), began_(std::chrono::steady_clock::now())
{
    clock_.go_on(state.time, file_.last_time());
    if (!file_.first_row()) return;
    initial_mass_ = file_.value(*file_.first_row(), "mass_kg");
    earlier_wall_time_ = file_.value(file_.last_rows().back(), "wall_s");
}

void StepsWriter::remember(const StepReport& report)
{
    if (report.time_step.dt <= 0.0) return; // before the first step
    if (!natural_step_ || report.time_step.limiter != TimeStepLimiter::output)
        natural_step_ = report.time_step;
}

double StepsWriter::wall_time() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

double StepsWriter::time_left(double time) const
{
    const double done = time - start_time_;
    return done > 0.0 ? wall_time() * (end_time_ - time) / done : PointSample::none;
}

void StepsWriter::observe(const Problem& problem, const State& state, const StepReport& report)
{
    remember(report);
    const Monitors monitors = monitor(problem, state, {});
    const double mass = monitors.mass_solid + monitors.mass_fluid;
    if (!initial_mass_) initial_mass_ = mass;
    CsvRow row{csv_number(state.time), std::to_string(report.step)};
    row.push_back(natural_step_ ? csv_number(natural_step_->dt) : "");
    row.emplace_back(natural_step_ ? name_of(natural_step_->limiter) : "");
    row.push_back(natural_step_ ? csv_cell(natural_step_->material) : "");
    row.emplace_back(natural_step_ ? name_of(natural_step_->scheme) : "");
    row.push_back(natural_step_ && natural_step_->replaced > 0.0 ? csv_number(natural_step_->replaced) : "");
    for (const double value : {earlier_wall_time_ + wall_time(), time_left(state.time), mass,
                               (mass - *initial_mass_) / *initial_mass_, monitors.momentum_x,
                               monitors.momentum_y, monitors.kinetic_energy, monitors.max_velocity})
        row.push_back(csv_number(value));
    if (problem.water) row.push_back(csv_number(monitors.max_ru));
    file_.add_row(row);
    file_.flush();
    while (clock_.next() <= state.time) clock_.advance();
}

} // namespace quicksand
