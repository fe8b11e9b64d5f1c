#include "io/history_csv.hpp"

#include <utility>

namespace quicksand {

namespace {

struct Column {
    std::string name;
    double value = 0.0;
};

/// One list for header and rows, so that they cannot differ.
std::vector<Column> columns_of(const Problem& problem, const Monitors& monitors, double time,
                               std::int64_t limited_domains)
{
    std::vector<Column> columns{
        {"time_s", time},
        {"base_acceleration_m_s2", base_acceleration(problem.base_motion, time)},
        {"crest_settlement_m", monitors.crest_settlement},
        {"max_displacement_m", monitors.max_displacement},
        {"max_velocity_m_s", monitors.max_velocity},
    };
    if (problem.water)
        columns.insert(columns.end(), {{"max_excess_pore_pressure_Pa", monitors.max_excess_pore_pressure},
                                       {"max_ru", monitors.max_ru},
                                       {"mass_fluid_kg", monitors.mass_fluid}});
    columns.insert(columns.end(), {{"mass_solid_kg", monitors.mass_solid},
                                   {"volume_m3", monitors.volume},
                                   {"momentum_x_N_s", monitors.momentum_x},
                                   {"momentum_y_N_s", monitors.momentum_y},
                                   {"kinetic_energy_J", monitors.kinetic_energy},
                                   {"limited_domains", static_cast<double>(limited_domains)}});
    return columns;
}

std::vector<std::string> column_names(const Problem& problem)
{
    std::vector<std::string> names;
    for (const Column& column : columns_of(problem, Monitors{}, 0.0, 0)) names.push_back(column.name);
    return names;
}

CsvFile open_file(const Problem& problem, double time, const RunLabel& label,
                  const std::filesystem::path& path, bool resume)
{
    std::vector<std::string> comments = run_comments(label);
    comments.insert(
        comments.end(),
        {"sums are per metre of thickness and of both phases; velocities are relative to the base",
         "crest_settlement: mean of the particles that lay highest when shaking began, positive downward",
         "limited_domains: particle domains shortened to a cell in the last step"});
    if (problem.water)
        comments.emplace_back("max_ru: largest excess pore pressure / initial vertical effective stress");
    return resume ? CsvFile::resume(path, comments, column_names(problem), time)
                  : CsvFile::begin(path, comments, column_names(problem));
}

} // namespace

std::vector<std::int32_t> reference_crest(const Particles& particles)
{
    // A resumed run has moved already, and must find the crest it began with.
    Particles at_start = particles;
    at_start.position = particles.reference_position;
    at_start.half_edge_1 = particles.reference_edge_1;
    at_start.half_edge_2 = particles.reference_edge_2;
    return crest_particles(at_start);
}

HistoryWriter::HistoryWriter(const Scene& scene, const Problem& problem, const State& state,
                             const RunLabel& label, const std::filesystem::path& path, bool resume)
    : clock_(scene.output.history_interval, scene.end_time),
      file_(open_file(problem, state.time, label, path, resume)), crest_(reference_crest(state.particles))
{
    clock_.go_on(state.time, file_.last_time());
}

void HistoryWriter::observe(const Problem& problem, const State& state, const StepReport& report)
{
    const Monitors monitors = monitor(problem, state, crest_);
    CsvRow row;
    for (const Column& column : columns_of(problem, monitors, state.time, report.limited_domains))
        row.push_back(csv_number(column.value));
    file_.add_row(row);
    file_.flush();
    clock_.advance();
}

} // namespace quicksand
