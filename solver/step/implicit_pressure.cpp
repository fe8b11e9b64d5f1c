// The implicit pressure of a step that is under way: its equations from the particles and the sums of the
// nodes, and its forces on them (pressure_solve.hpp).
#include "solver/base/failure.hpp"
#include "solver/boundaries/boundary_compliance.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/step/two_phase_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace quicksand {

namespace {

/// The solve ends before its last iteration only where it meets what is not a number.
[[noreturn]] void fail_to_solve(const PressureSolve& pressure, const PressureSolveControls& controls,
                                double dt, const State& state)
{
    const bool is_number = pressure.iterations >= controls.max_iterations;
    FailureRecord record = failure_at(dt, state, fastest_particle(state.particles));
    record.phase = "pressure";
    record.what = is_number ? "the pressure of the cells is not found within " +
                                  std::to_string(pressure.iterations) + " iterations"
                            : "the pressure of the cells is not a number, nor is the motion it follows from";
    record.what += "; the particle below is the fastest";
    record.causes = causes_of_instability;
    throw NumericalError(record);
}

/// Deficits and limits of the cells; soil without water has neither.
void set_up_cavities(const Problem& problem, const Particles& particles, SemiImplicitWorkspace& work)
{
    CavitySolve& cavity = work.pressure.cavity;
    if (cavity.cavities.empty()) return;
    std::fill(cavity.deficit.begin(), cavity.deficit.end(), 0.0);
    std::fill(cavity.lowest_increment.begin(), cavity.lowest_increment.end(),
              -std::numeric_limits<double>::infinity());
    const CellLists& lists = work.lists_with_pressure();
    for_each_tile(lists, [&](const Tile& tile) {
        prepare_cavities(problem, lists, tile, particles, work.pressure.expected, cavity.deficit,
                         cavity.lowest_increment);
    });
}

/// The flux changes over velocity_dt and fills cells over dt: dt velocity_dt in the place of dt^2.
double common_interval(double dt, double velocity_dt)
{
    return std::sqrt(dt * velocity_dt);
}

/// Give the equations the fluxes of the motion; returns the interval that stands for both.
double set_fluxes(double dt, double velocity_dt, SemiImplicitWorkspace& work)
{
    const double step = common_interval(dt, velocity_dt);
    PressureSolve& pressure = work.pressure;
    for_each_index(work.motion.size(), [&](std::size_t i) {
        pressure.flux_x[i] = dt / step * work.motion[i].flux_x;
        pressure.flux_y[i] = dt / step * work.motion[i].flux_y;
    });
    return step;
}

} // namespace

void set_up_pressure(const Problem& problem, double dt, double velocity_dt, const Particles& particles,
                     SemiImplicitWorkspace& work)
{
    PressureSolve& pressure = work.pressure;
    if (work.partly_wet) {
        // soil without water gives cells no divergence, and cells of such soil alone an equation dp = 0
        set_wet_volumes(problem, particles, work.wet_volume);
        std::fill(pressure.storage.begin(), pressure.storage.end(), 1.0);
        std::fill(pressure.expected.begin(), pressure.expected.end(), 0.0);
    }
    std::fill(pressure.increment.begin(), pressure.increment.end(), 0.0);
    const Scalars& volume = work.partly_wet ? work.wet_volume : particles.volume;
    const CellLists& lists = work.lists_with_pressure();
    for_each_tile(work.lists, [&](const Tile& tile) {
        assemble_divergence(problem.grid, volume, work.lists, tile, work.stencils_of(tile),
                            pressure.divergence[static_cast<std::size_t>(tile.number)]);
        prepare_increments(problem, dt, lists, tile, particles, pressure.storage, pressure.expected);
    });
    set_up_cavities(problem, particles, work);
    set_pressure_compliances(problem, work.conditions, velocity_dt, work.sums, pressure.compliance);
    include_dashpots(problem, work.conditions, velocity_dt, work.dashpots, work.sums, pressure.compliance);
    Scalars porosities;
    for (const std::size_t i : work.walls.rows.nodes())
        porosities.push_back(node_porosity(problem, work.sums[i]));
    set_row_response(porosities, work.walls.rows, pressure);
    if (work.walls.any) aggregate_pressures(work.walls.shared_pressures(), pressure);
}

void prepare_pressure(const Problem& problem, double dt, double velocity_dt, const Particles& particles,
                      SemiImplicitWorkspace& work)
{
    const double step = common_interval(dt, velocity_dt);
    choose_blocks(step, work.pressure);
    set_up_pressure(problem, dt, velocity_dt, particles, work);
    set_up_preconditioner(problem.grid, work.lists, work.conditions, step, work.pressure);
}

void add_increment_forces(const Problem& problem, SemiImplicitWorkspace& work)
{
    PressureSolve& pressure = work.pressure;
    set_increment_forces(problem.grid, work.lists, work.conditions, pressure);
    for_each_index(work.sums.size(), [&](std::size_t i) {
        work.sums[i].pressure_force_x += pressure.force_x[i];
        work.sums[i].pressure_force_y += pressure.force_y[i];
        pressure.force_x[i] = pressure.force_y[i] = 0.0;
    });
}

void find_increments(const Problem& problem, double dt, double velocity_dt, const State& state,
                     SemiImplicitWorkspace& work)
{
    PressureSolve& pressure = work.pressure;
    const double step = set_fluxes(dt, velocity_dt, work);
    if (!solve_increments(problem.grid, work.lists, work.conditions, step, work.controls, pressure))
        fail_to_solve(pressure, work.controls, dt, state);
    set_changes(work.lists, pressure);
    add_increment_forces(problem, work);
}

} // namespace quicksand
