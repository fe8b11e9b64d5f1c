#include "solver/two_phase_step.hpp"

#include "solver/grid_momentum.hpp"
#include "solver/grid_to_particle.hpp"
#include "solver/ledger.hpp"
#include "solver/particle_motion.hpp"
#include "solver/particle_to_grid.hpp"
#include "solver/surface_loads.hpp"

namespace quicksand {

namespace {

void scatter(const Problem& problem, double load_time, const Particles& particles, TwoPhaseWorkspace& work)
{
    work.sums.assign(work.sums.size(), TwoPhaseSums{});
    for_each_weighted_tile(problem, particles, work, [&](const Tile& tile) {
        scatter_two_phase(problem, particles, work.lists, tile, work.patches_of(tile), work.sums);
    });
    scatter_surface_loads(problem, load_time, particles, work.places, work.sums);
}

void solve_momentum(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work)
{
    gather_tied_sums(work.conditions, work.sums);
    const double acceleration = base_acceleration(problem.base_motion, state.time + 0.5 * dt);
    solve_two_phase_momentum(problem, work.conditions, dt, acceleration, work.sums, work.motion);
    if (state.ledger)
        enter_nodes(problem, work.ledger_nodes, dt, acceleration, work.sums, work.motion, *state.ledger);
    spread_tied_motion(work.conditions, work.motion);
}

} // namespace

TwoPhaseWorkspace make_two_phase_workspace(const Problem& problem)
{
    TwoPhaseWorkspace work;
    set_up_workspace(problem, work);
    work.sums.resize(problem.grid.node_count());
    work.motion.resize(problem.grid.node_count());
    work.cell_means.volume.resize(problem.grid.cell_count());
    work.cell_means.pore_pressure.resize(problem.grid.cell_count());
    work.cell_means.centre.x.resize(problem.grid.cell_count());
    work.cell_means.centre.y.resize(problem.grid.cell_count());
    return work;
}

void advance_two_phase_step(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work)
{
    Particles& particles = state.particles;
    work.flux_divergence.resize(particles.size());
    timed(work.timers, Phase::sort, [&] { locate_particles(problem, dt, state, work); });
    timed(work.timers, Phase::scatter, [&] { scatter(problem, load_time(state, dt), particles, work); });
    timed(work.timers, Phase::momentum, [&] { solve_momentum(problem, dt, state, work); });
    timed(work.timers, Phase::gather, [&] {
        const double share = dt / (dt + work.noise_time);
        for_each_tile(work.lists, [&](const Tile& tile) {
            gather_two_phase(problem, dt, share, work.lists, tile, work.patches_of(tile), work.motion,
                             particles, work.grid_velocity, work.flux_divergence);
        });
    });
    timed(work.timers, Phase::pore_pressure, [&] {
        if (state.ledger) enter_outflow(dt, particles, work.flux_divergence, *state.ledger);
        for_each_tile(work.lists, [&](const Tile& tile) {
            update_pore_pressure(problem, dt, work.lists, tile, work.flux_divergence, particles,
                                 work.cell_means);
        });
        for_each_tile(work.lists, [&](const Tile& tile) {
            reconstruct_pore_pressure(problem, work.lists, tile, work.cell_means, particles);
        });
    });
    timed(work.timers, Phase::motion, [&] {
        const auto velocity = [&](std::size_t i) {
            return Vector2(work.motion[i].solid_x, work.motion[i].solid_y);
        };
        move_particles(problem, dt, work.grid_velocity, velocity, state);
    });
    timed(work.timers, Phase::stress, [&] {
        update_stress_of_cells(problem, dt, work.lists, particles, work.average);
        shorten_carried_gradients(problem.grid.cell_size, particles);
    });
    state.time += dt;
    ++state.step;
}

} // namespace quicksand
