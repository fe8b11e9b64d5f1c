#include "io/results/history_csv.hpp"

#include "solver/measure/ledger.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/measure/pressure_noise.hpp"
#include "solver/particles/background_grid.hpp"

#include <fmt/format.h>

#include <utility>

namespace quicksand {

namespace {

struct Column {
    std::string name;
    double value = 0.0;
};

/// Works, balances and their errors since the ledger was opened.
std::vector<Column> ledger_columns(const Problem& problem, const State& state)
{
    const Ledger& ledger = *state.ledger;
    const LedgerBalance balances = balance(problem, state);
    std::vector<Column> columns{
        {"skeleton_work_J", ledger.skeleton_work},
        {"gravity_work_J", ledger.gravity_work},
        {"base_work_J", ledger.base_work},
        {"boundary_work_J", ledger.boundary_work},
        {"numerical_loss_J", balances.numerical_loss},
        {"energy_error", balances.energy_error},
        {"impulse_x_N_s", ledger.impulse_x},
        {"impulse_y_N_s", ledger.impulse_y},
        {"momentum_error_x_N_s", balances.momentum_error_x},
        {"momentum_error_y_N_s", balances.momentum_error_y},
    };
    if (problem.water)
        columns.insert(columns.end(), {{"drag_dissipation_J", ledger.drag_dissipation},
                                       {"water_outflow_m3", ledger.outflow},
                                       {"water_error", balances.water_error}});
    return columns;
}

/// One list for header and rows, so that they cannot differ.
std::vector<Column> columns_of(const Problem& problem, const State& state, const Monitors& monitors,
                               std::int64_t limited_domains)
{
    const double time = state.time;
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
    const PressureNoise noise = measure_pressure_noise(problem, state.particles);
    columns.insert(columns.end(), {{"mean_stress_checkerboard", noise.mean_stress_checkerboard},
                                   {"mean_stress_scatter", noise.mean_stress_scatter}});
    if (problem.water) columns.push_back({"pore_pressure_checkerboard", noise.pore_pressure_checkerboard});
    if (problem.water)
        columns.insert(columns.end(), {{"kinetic_energy_water_J", monitors.kinetic_energy_fluid},
                                       {"storage_energy_water_J", storage_energy(problem, state.particles)},
                                       {"pore_volume_m3", monitors.mass_fluid / problem.water->density},
                                       {"water_content_m3", water_content(problem, state.particles)}});
    if (state.ledger) {
        const std::vector<Column> more = ledger_columns(problem, state);
        columns.insert(columns.end(), more.begin(), more.end());
    }
    return columns;
}

std::vector<std::string> column_names(const Problem& problem, const State& state)
{
    std::vector<std::string> names;
    for (const Column& column : columns_of(problem, state, Monitors{}, 0)) names.push_back(column.name);
    return names;
}

/// What the columns of the balances mean.
std::vector<std::string> ledger_comments(const Problem& problem)
{
    std::vector<std::string> comments{
        "works and impulses: since t = 0; of the stress on the skeleton (stored and dissipated), of the "
        "weight "
        "(buoyant below water), of the base's acceleration, of loads and moving walls; energies are in J per "
        "m",
        "numerical_loss: kinetic energy lost between particles and grid and at walls, by the scheme alone",
        "energy_error: what kinetic energy, stored energy, works and losses leave / the sum of their sizes",
        "momentum_error: momentum less that at t = 0, the impulses and what came with changes of pore "
        "volume"};
    if (problem.water) {
        comments.emplace_back(
            "water_content: volume of the pore water without its pressure; water_outflow: what "
            "left the soil since t = 0; water_error: what the two leave / content at t = 0");
    }
    return comments;
}

CsvFile open_file(const Problem& problem, const State& state, const RunLabel& label,
                  const std::filesystem::path& path, bool resume)
{
    std::vector<std::string> comments = run_comments(label);
    comments.insert(
        comments.end(),
        {"sums are per metre of thickness and of both phases; velocities are relative to the base",
         "crest_settlement: mean of the particles that lay highest when shaking began, positive downward",
         fmt::format(
             "limited_domains: particle domains scaled down in the last step, as they reached farther "
             "than {} cells from their centre",
             BackgroundGrid::domain_reach),
         ("checkerboard: |sum (-1)^(i+j) p_c V_c| / sum |p_c| V_c over the cells; above 0.05 neighbours "
          "disagree"),
         ("mean_stress_scatter: mean effective stress of the particles off the plane through their cells / "
          "its size; tenths where volume locks")});
    if (problem.water)
        comments.emplace_back("max_ru: largest excess pore pressure / initial vertical effective stress");
    if (state.ledger) {
        const std::vector<std::string> more = ledger_comments(problem);
        comments.insert(comments.end(), more.begin(), more.end());
    }
    return resume ? CsvFile::resume(path, comments, column_names(problem, state), state.time)
                  : CsvFile::begin(path, comments, column_names(problem, state));
}

} // namespace

std::vector<std::int32_t> reference_crest(const Particles& particles)
{
    // A resumed run has moved already, and must find the crest it began with.
    Particles at_start = particles;
    return_to_reference(at_start);
    return crest_particles(at_start);
}

HistoryWriter::HistoryWriter(const Scene& scene, const Problem& problem, const State& state,
                             const RunLabel& label, const std::filesystem::path& path, bool resume)
    : clock_(scene.output.history_interval, scene.end_time),
      file_(open_file(problem, state, label, path, resume)), crest_(reference_crest(state.particles))
{
    clock_.go_on(state.time, file_.last_time());
}

void HistoryWriter::observe(const Problem& problem, const State& state, const StepReport& report)
{
    const Monitors monitors = monitor(problem, state, crest_);
    CsvRow row;
    for (const Column& column : columns_of(problem, state, monitors, report.limited_domains))
        row.push_back(csv_number(column.value));
    file_.add_row(row);
    file_.flush();
    clock_.advance();
}

} // namespace quicksand
