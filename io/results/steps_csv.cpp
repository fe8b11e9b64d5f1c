#include "io/results/steps_csv.hpp"

#include "io/results/probe_sample.hpp"

#include <algorithm>

namespace quicksand {

namespace {

std::vector<std::string> column_names(const Problem& problem)
{
    std::vector<std::string> names{"time_s",          "step",           "dt_s",           "dt_limiter",
                                   "dt_material",     "wall_s",         "eta_s",          "mass_kg",
                                   "mass_error",      "momentum_x_N_s", "momentum_y_N_s", "kinetic_J",
                                   "max_velocity_m_s"};
    if (problem.water) names.emplace_back("max_ru");
    return names;
}

/// A name as a cell: what would break the row or the line is replaced, since rows are read by their commas.
std::string cell_of(std::string name)
{
    const auto breaks = [](char letter) {
        return letter == ',' || letter == '"' || static_cast<unsigned char>(letter) < 0x20U;
    };
    std::replace_if(name.begin(), name.end(), breaks, '_');
    return name;
}

CsvFile open_file(const Problem& problem, double time, const RunLabel& label,
                  const std::filesystem::path& path, bool resume)
{
    std::vector<std::string> comments = run_comments(label);
    comments.insert(comments.end(),
                    {"dt: the last time step that was not shortened to hit an output time",
                     "wall: time since the run began, over all its processes; eta: estimate of what is left",
                     "mass: of both phases; mass_error: its change since the first row, relative",
                     "sums are per metre of thickness; velocities are relative to the base"});
    return resume ? CsvFile::resume(path, comments, column_names(problem), time)
                  : CsvFile::begin(path, comments, column_names(problem));
}

} // namespace

StepsWriter::StepsWriter(const Scene& scene, const Problem& problem, const State& state,
                         const RunLabel& label, const std::filesystem::path& path, bool resume)
    : clock_(scene.output.history_interval, scene.end_time),
      file_(open_file(problem, state.time, label, path, resume)), start_time_(state.time),
      end_time_(scene.end_time), began_(std::chrono::steady_clock::now())
{
    clock_.go_on(state.time, file_.last_time());
    if (!file_.first_row()) return;
    initial_mass_ = file_.value(*file_.first_row(), "mass_kg");
    earlier_wall_time_ = file_.value(file_.last_rows().back(), "wall_s");
}

void StepsWriter::after_step(const StepReport& report)
{
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
    return done > 0.0 ? wall_time() * (end_time_ - time) / done : ProbeSample::none;
}

void StepsWriter::observe(const Problem& problem, const State& state, const StepReport& report)
{
    const Monitors monitors = monitor(problem, state, {});
    const double mass = monitors.mass_solid + monitors.mass_fluid;
    if (!initial_mass_) initial_mass_ = mass;
    CsvRow row{csv_number(state.time), std::to_string(report.step)};
    row.push_back(natural_step_ ? csv_number(natural_step_->dt) : "");
    row.emplace_back(natural_step_ ? name_of(natural_step_->limiter) : "");
    row.push_back(natural_step_ ? cell_of(natural_step_->material) : "");
    for (const double value : {earlier_wall_time_ + wall_time(), time_left(state.time), mass,
                               (mass - *initial_mass_) / *initial_mass_, monitors.momentum_x,
                               monitors.momentum_y, monitors.kinetic_energy, monitors.max_velocity})
        row.push_back(csv_number(value));
    if (problem.water) row.push_back(csv_number(monitors.max_ru));
    file_.add_row(row);
    file_.flush();
    clock_.advance();
}

} // namespace quicksand
