#include "solver/step/two_phase_step.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/parallel_tasks.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/outer_forces.hpp"
#include "solver/boundaries/solid_seals.hpp"
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/inertia/coupled_motion.hpp"
#include "solver/measure/balances.hpp"
#include "solver/motion/grid_to_particle.hpp"
#include "solver/motion/particle_motion.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/motion/particle_to_grid.hpp"
#include "solver/motion/slivers.hpp"
#include "solver/step_length/accuracy_control.hpp"

#include <algorithm>
#include <vector>

namespace quicksand {

namespace {

/// `velocity_dt` is the time over which the forces act, see velocity_interval [s].
void solve_two_phase_velocities(const Problem& problem, double velocity_dt, const State& state,
                                TwoPhaseWorkspace& work)
{
    const double acceleration = base_acceleration(problem.base_motion, state.time);
    solve_two_phase_momentum(problem, work.conditions, velocity_dt, acceleration, work.sums, work.motion);
    brake_by_dashpots(problem, work.conditions, velocity_dt, work.dashpots, work.sums, work.motion);
    hold_at_walls(problem, work.sums, work.walls, work.motion);
    spread_tied_motion(work.conditions, work.motion);
}

void enter_works(const Problem& problem, double velocity_dt, const Working& working, TwoPhaseWorkspace& work,
                 State& state)
{
    if (!state.balance_terms) return;
    const double acceleration = base_acceleration(problem.base_motion, state.time);
    const double skeleton = enter_nodes(problem, work.balance_nodes, velocity_dt, acceleration, working,
                                        work.sums, work.outer, work.motion, *state.balance_terms);
    if (work.walls.moves)
        enter_moving_walls(problem, velocity_dt, acceleration, working, work.sums, work.motion,
                           work.walls.rows, work.walls.changes, *state.balance_terms);
    if (work.inertia) work.work_of_nodes = skeleton;
}

void gather(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work)
{
    Particles& particles = state.particles;
    const double fraction = dt / (dt + work.null_space_time);
    for_each_tile(work.lists, [&](const Tile& tile) {
        gather_two_phase(problem, dt, fraction, work.lists, tile, work.stencils_of(tile), work.motion,
                         particles, work.grid_velocity, work.flux_divergence);
    });
    if (work.partly_wet) carry_moisture(problem, particles);
    if (!state.balance_terms) return;
    enter_outflow(problem, dt, particles, work.flux_divergence, *state.balance_terms);
    enter_exchange(problem, dt, particles, *state.balance_terms);
}

/// The volume of the water changes with that of the pores, also by what the divergence does not tell of a
/// turn.
void add_growth_of_turns(const Problem& problem, double dt, const Particles& particles, Scalars& divergence)
{
    if (problem.strain == StrainForm::small) return;
    for_each_index(divergence.size(), [&](std::size_t p) {
        divergence[p] += growth_of_turn(dt, particles.velocity_gradient_solid, p);
    });
}

/// The same where the pressure is solved for before the motion is known: turns go on from step to step.
void expect_growth_of_turns(const Problem& problem, double dt, const Particles& particles,
                            SemiImplicitWorkspace& work)
{
    if (problem.strain == StrainForm::small) return;
    Scalars& growth = work.pressure.growth;
    growth.assign(problem.grid.cell_count(), 0.0);
    const CellLists& lists = work.lists_with_pressure();
    for_each_tile(lists, [&](const Tile& tile) { sum_growth_of_turns(dt, lists, tile, particles, growth); });
}

/// Velocities and pressures of a step, from equations that are ready.
void answer(const Problem& problem, double dt, double velocity_dt, State& state, SemiImplicitWorkspace& work)
{
    timed(work.timers, Phase::pore_pressure, [&] { find_increments(problem, dt, velocity_dt, state, work); });
    timed(work.timers, Phase::momentum,
          [&] { solve_two_phase_velocities(problem, velocity_dt, state, work); });
}

/// What the pressure of a cell answers to an inflow besides the blocks of the preconditioner, because the
/// grains resist by their stiffness. A wave of k^2 meets k^2 (q + g^2/(m + s k^2)), q and g^2/m being the
/// flux of water and grains and s = beta M/V; with d = m q + g^2 the inverse is
///   (m/d)/k^2 + (g^2/d)/(q k^2 + d/s),
/// the blocks being the first part. k^2 of all waves is some 2.5 times that of a cell alone in the second,
/// and of s two fifths take the fewest iterations: 4 to 8.
void set_stiffness_of_cells(const BackgroundGrid& grid, SemiImplicitWorkspace& work)
{
    constexpr double part = 0.4, of_single_cell = 2.5;
    const InertiaSolve& inertia = *work.inertia;
    PressureSolve& pressure = work.pressure;
    const double per_area = part * inertia.resistance / (grid.cell_size * grid.cell_size);
    const auto cells_x = static_cast<std::size_t>(grid.all_cells_x()),
               nodes_x = static_cast<std::size_t>(grid.nodes_x());
    pressure.stiffness.resize(work.lists.cell_of_slot.size());
    for_each_index(pressure.stiffness.size(), [&](std::size_t slot) {
        const auto cell = static_cast<std::size_t>(work.lists.cell_of_slot[slot]);
        const std::size_t column = cell % cells_x, row = cell / cells_x, node = row * nodes_x + column;
        const double resisting = per_area * inertia.cells.constrained[inertia.rows.place(column, row)];
        pressure.stiffness[slot] = 0.0;
        if (!(resisting > 0.0)) return;
        FluxParts flux;
        for (const std::size_t corner : {node, node + 1, node + nodes_x, node + nodes_x + 1})
            flux += inertia.response.flux_parts(corner);
        if (!(flux.mobility > 0.0)) return;
        const double of_cell = pressure.diagonal[slot] - pressure.storage[slot],
                     all = flux.of_water + flux.of_grains;
        pressure.stiffness[slot] = flux.of_grains / (of_single_cell * flux.of_water * of_cell +
                                                     all * all / (flux.mobility * resisting));
    });
}

/// The same with the inertia of the skeleton's stiffness.
void answer_with_inertia(const Problem& problem, double dt, double velocity_dt, State& state,
                         SemiImplicitWorkspace& work)
{
    const auto resist = [&] {
        timed(work.timers, Phase::inertia, [&] { resist_acceleration(dt, velocity_dt, work); });
        timed(work.timers, Phase::momentum,
              [&] { solve_two_phase_velocities(problem, velocity_dt, state, work); });
    };
    timed(work.timers, Phase::inertia, [&] {
        const auto set_up = [&](std::size_t equations) {
            if (equations == 0)
                set_up_inertia(problem, dt, velocity_dt, work);
            else
                prepare_pressure(problem, dt, velocity_dt, state.particles, work);
        };
        rethrow_first(attempt_each(2, set_up, std::min(2, threads_for(state.particles.size()))));
        set_stiffness_of_cells(problem.grid, work);
    });
    work.pressure.stiff_response = [&](const Scalars& force_x, const Scalars& force_y, Scalars& flux_x,
                                       Scalars& flux_y) {
        work.inertia->response.answer_pressure(force_x, force_y, flux_x, flux_y);
    };
    resist();
    answer(problem, dt, velocity_dt, state, work);
    resist();
    // What single precision has left of the pressure's large forces on nearly empty nodes; and rows that
    // nearly repeat each other yield less in the balance of momentum than in the factor.
    constexpr double enough = 1e-4;
    constexpr int most_corrections = 8;
    for (int k = 0; k < most_corrections && missing_inertia(dt, work) > enough; ++k) resist();
    work.pressure.stiff_response = nullptr;
}

/// The same of a long step, in which stiffness and pressure are factorised together.
void answer_together(const Problem& problem, double dt, double velocity_dt, State& state,
                     SemiImplicitWorkspace& work)
{
    PressureSolve& pressure = work.pressure;
    timed(work.timers, Phase::pore_pressure,
          [&] { set_up_pressure(problem, dt, velocity_dt, state.particles, work); });
    timed(work.timers, Phase::inertia, [&] {
        const double acceleration = base_acceleration(problem.base_motion, state.time);
        if (!move_coupled(problem, work.conditions, dt, velocity_dt, acceleration, work.dashpots,
                          work.walls.rows, work.sums, work.motion, *work.inertia, pressure, work.coupled))
            fail_to_resist(dt, state);
        if (!pressure.cavity.cavities.empty()) pressure.cavity.water_increment = pressure.increment;
        set_changes(work.lists, pressure);
        add_increment_forces(problem, work);
    });
}

void move_and_deform(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work)
{
    timed(work.timers, Phase::motion, [&] {
        const auto velocity = [&](std::size_t i) {
            return Vector2(work.motion[i].solid_x, work.motion[i].solid_y);
        };
        move_particles(problem, dt, work.grid_velocity, velocity, state);
    });
    timed(work.timers, Phase::stress, [&] { update_stresses(problem, dt, work, state); });
    carry_slivers(problem, work.places, state);
    state.time += dt;
    state.last_step = dt;
    ++state.step;
}

} // namespace

TwoPhaseWorkspace make_two_phase_workspace(const Problem& problem)
{
    ENSURE(!problem.body_acceleration); // of bodies of one phase only
    TwoPhaseWorkspace work;
    set_up_workspace(problem, work);
    work.sums.resize(problem.grid.node_count());
    work.motion.resize(problem.grid.node_count());
    work.cell_means = make_cell_means(problem);
    work.layered_drag = make_layered_drag(problem);
    work.pressure_increment.resize(problem.grid.cell_count());
    if (problem.water->rises_above_level || has_outer_forces(problem))
        work.outer.resize(problem.grid.node_count());
    return work;
}

SemiImplicitWorkspace make_semi_implicit_workspace(const Problem& problem)
{
    SemiImplicitWorkspace work{make_two_phase_workspace(problem), {}, {}, {}};
    work.pressure =
        make_pressure_solve(work.lists.tiles.size(), problem.grid.cell_count(), problem.grid.node_count());
    if (problem.water->cavitation_pressure) add_cavities(work.pressure);
    return work;
}

void scatter_to_nodes(const Problem& problem, double dt, double time, const State& state,
                      TwoPhaseWorkspace& work)
{
    const Particles& particles = state.particles;
    set_to_zero(work.sums);
    work.outer.assign(work.outer.size(), OuterForce{});
    for_each_weighted_tile(problem, particles, work, [&](const Tile& tile) {
        scatter_two_phase(problem, particles, work.lists, tile, work.stencils_of(tile), work.sums);
        if (problem.water->rises_above_level)
            scatter_risen_water(problem, particles, work.lists, tile, work.stencils_of(tile), work.sums,
                                work.outer);
    });
    gather_outer_forces(problem, time, state, work.places, work.outer_forces);
    add_outer_forces(work.outer_forces, work.sums);
    if (state.balance_terms && !work.outer.empty()) note_outer_forces(work.outer_forces, work.outer);
    place_boundaries(problem, dt, state, work);
    gather_tied_sums(work.conditions, work.sums);
    gather_tied_sums(work.conditions, work.outer);
    if (!work.drawn_conditions.empty())
        seal_by_solids(problem, particles, work.lists, work.sums, work.drawn_conditions, work.conditions);
    set_drag(problem, particles, work.lists, work.stencils, work.conditions, work.sums, work.layered_drag);
}

void advance_two_phase_step(const Problem& problem, double dt, State& state, TwoPhaseWorkspace& work)
{
    Particles& particles = state.particles;
    work.flux_divergence.resize(particles.size());
    timed(work.timers, Phase::sort, [&] { locate_particles(problem, dt, state, work); });
    timed(work.timers, Phase::scatter, [&] {
        const StressOnNodes stress(problem, work.volume_lists(), work.cell_strain, particles);
        scatter_to_nodes(problem, dt, state.time, state, work);
    });
    timed(work.timers, Phase::momentum, [&] {
        const double velocity_dt = velocity_interval(state, dt);
        centre_drag(velocity_dt, explicit_strong_drag, work.sums);
        assemble_walls(problem, velocity_dt, work.sums, work);
        solve_two_phase_velocities(problem, velocity_dt, state, work);
        enter_works(problem, velocity_dt, {}, work, state);
    });
    timed(work.timers, Phase::gather, [&] { gather(problem, dt, state, work); });
    timed(work.timers, Phase::pore_pressure, [&] {
        add_growth_of_turns(problem, dt, particles, work.flux_divergence);
        advance_pore_pressure(problem, dt, work.lists_with_pressure(), work.pressure_increment, particles,
                              work.cell_means, [&](const Tile& tile) {
                                  explicit_increments(problem, dt, work.lists_with_pressure(), tile,
                                                      particles, work.flux_divergence,
                                                      work.pressure_increment);
                              });
    });
    move_and_deform(problem, dt, state, work);
}

void advance_semi_implicit_step(const Problem& problem, double dt, State& state, SemiImplicitWorkspace& work)
{
    Particles& particles = state.particles;
    work.flux_divergence.resize(particles.size());
    particles.pore_pressure_rate.resize(particles.size());
    timed(work.timers, Phase::sort, [&] { locate_particles(problem, dt, state, work); });
    timed(work.timers, Phase::scatter, [&] {
        const StressOnNodes stress(problem, work.volume_lists(), work.cell_strain, particles);
        scatter_to_nodes(problem, dt, state.time, state, work);
    });
    const double velocity_dt = velocity_interval(state, dt);
    timed(work.timers, Phase::momentum, [&] {
        centre_drag(velocity_dt, semi_implicit_strong_drag, work.sums);
        assemble_walls(problem, velocity_dt, work.sums, work);
    });
    bool together = false;
    if (work.inertia)
        timed(work.timers, Phase::inertia, [&] {
            sum_moduli(problem, dt, particles, work);
            choose_resistance(problem, state, *work.inertia);
            together = is_long_step(problem, dt, work.sums, *work.inertia);
        });
    timed(work.timers, Phase::pore_pressure, [&] { expect_growth_of_turns(problem, dt, particles, work); });
    if (together) {
        answer_together(problem, dt, velocity_dt, state, work);
    } else {
        timed(work.timers, Phase::momentum,
              [&] { solve_two_phase_velocities(problem, velocity_dt, state, work); });
        if (work.inertia) {
            answer_with_inertia(problem, dt, velocity_dt, state, work);
        } else {
            timed(work.timers, Phase::pore_pressure,
                  [&] { prepare_pressure(problem, dt, velocity_dt, particles, work); });
            answer(problem, dt, velocity_dt, state, work);
        }
    }
    timed(work.timers, Phase::momentum,
          [&] { enter_works(problem, velocity_dt, working_of(dt, velocity_dt, work), work, state); });
    timed(work.timers, Phase::gather, [&] { gather(problem, dt, state, work); });
    timed(work.timers, Phase::pore_pressure, [&] {
        const PressureSolve& pressure = work.pressure;
        advance_solved_pressure(
            problem, dt, work.lists_with_pressure(),
            {pressure.expected, pressure.increment, pressure.change, following_part(dt, state.last_step)},
            particles, work.cell_means);
    });
    move_and_deform(problem, dt, state, work);
}

} // namespace quicksand
