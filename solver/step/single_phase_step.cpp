#include "solver/step/single_phase_step.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/outer_forces.hpp"
#include "solver/boundaries/surface_loads.hpp"
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/inertia/coupled_motion.hpp"
#include "solver/measure/balances.hpp"
#include "solver/motion/grid_to_particle.hpp"
#include "solver/motion/null_space_damping.hpp"
#include "solver/motion/particle_motion.hpp"
#include "solver/motion/slivers.hpp"
#include "solver/step_length/accuracy_control.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// The velocities at the end of the step that the forces give.
void solve_single_phase_velocities(const Problem& problem, double velocity_dt, double acceleration,
                                   double damping, SinglePhaseWorkspace& work)
{
    solve_single_phase_momentum(problem, work.conditions, velocity_dt, acceleration, damping, work.sums,
                                work.motion);
    brake_by_dashpots(work.conditions, velocity_dt, work.dashpots, work.sums, work.motion);
    hold_at_walls(work.walls, work.motion);
}

/// Local damping takes part of a node's force; where stiffness resists, the forces within solids are far
/// larger than what moves them, and it takes part of what accelerates the node in the end: mass times
/// acceleration.
void damp_accelerations(double damping, double velocity_dt, SinglePhaseWorkspace& work)
{
    const auto brake = [&](double mass, double change, double momentum) {
        return local_damping(damping, velocity_dt, mass * change / velocity_dt, momentum);
    };
    for_each_index(work.sums.size(), [&](std::size_t i) {
        SinglePhaseSums& node = work.sums[i];
        node.stress_force_x += brake(node.mass, work.motion[i].change_x, node.momentum_x);
        node.stress_force_y += brake(node.mass, work.motion[i].change_y, node.momentum_y);
    });
}

/// The velocities at the end of the step where stiffness resists accelerations.
void solve_resisted(const Problem& problem, double dt, double velocity_dt, double acceleration,
                    double damping, const State& state, SinglePhaseWorkspace& work)
{
    const auto solve = [&] { solve_single_phase_velocities(problem, velocity_dt, acceleration, 0.0, work); };
    sum_moduli(problem, dt, state.particles, work);
    choose_resistance(problem, state, *work.inertia);
    if (damping == 0.0 && is_long_step(problem, dt, work.sums, *work.inertia)) {
        if (!move_coupled(problem, work.conditions, dt, velocity_dt, acceleration, work.dashpots,
                          work.walls.rows, work.sums, work.motion, *work.inertia, work.coupled))
            fail_to_resist(dt, state);
        return;
    }
    solve();
    set_up_inertia(problem, dt, velocity_dt, work);
    resist_acceleration(dt, velocity_dt, work);
    solve();
    if (damping == 0.0) return;
    const std::vector<SinglePhaseSums> undamped = work.sums;
    damp_accelerations(damping, velocity_dt, work);
    resist_acceleration(dt, velocity_dt, work);
    solve();
    work.sums = undamped; // what is out of balance is told without the damping
}

/// Whether pore pressures act on the body: they follow from its motion, or are constant. While the soil
/// settles drained with zero pore pressures everywhere, outer water does not act. It acts from the start of
/// the shaking, when pore pressures react; before, the grains alone would carry it and settle.
bool carries_pressure(const Problem& problem, const State& state)
{
    const Particles& particles = state.particles;
    const bool reacts = state.stage == Stage::shaking || settles_undrained(problem);
    return !particles.pore_pressure.empty() && (reacts || has_pressure(particles));
}

} // namespace

SinglePhaseWorkspace make_single_phase_workspace(const Problem& problem, Stage stage)
{
    SinglePhaseWorkspace work;
    set_up_workspace(problem, work, stage);
    work.sums.resize(problem.grid.node_count());
    work.motion.resize(problem.grid.node_count());
    if (has_outer_forces(problem)) work.outer.resize(problem.grid.node_count());
    if (water_flow(problem) == WaterFlow::undrained) {
        work.cell_means = make_cell_means(problem);
        work.pressure_increment.resize(problem.grid.cell_count());
    }
    return work;
}

void scatter_to_nodes(const Problem& problem, double dt, const State& state, SinglePhaseWorkspace& work)
{
    const Particles& particles = state.particles;
    const bool pressed = carries_pressure(problem, state);
    const auto scatter = pressed ? scatter_total_stress : scatter_single_phase;
    compute_carried_masses(problem, state, work.masses);
    set_to_zero(work.sums);
    for_each_weighted_tile(problem, particles, work, [&](const Tile& tile) {
        const StencilStore& store = work.stencils_of(tile);
        scatter(problem, particles, work.masses, work.lists, tile, store, work.sums);
        if (!problem.body_acceleration) return;
        scatter_body_force(problem, state.time, particles, work.masses, work.lists, tile, store, work.sums);
    });
    gather_outer_forces(problem, load_time(state), state, work.places, work.outer_forces);
    if (!pressed) // without pore pressures the grains alone would carry the water beyond curves
        for (NodalForce& force : work.outer_forces) force.mixture.setZero();
    add_outer_forces(work.outer_forces, work.sums);
    place_boundaries(problem, dt, state, work);
    gather_tied_sums(work.conditions, work.sums);
    if (work.outer.empty() || !state.balance_terms) return;
    work.outer.assign(work.outer.size(), OuterForce{});
    note_outer_forces(work.outer_forces, work.outer);
    gather_tied_sums(work.conditions, work.outer);
}

void advance_single_phase_step(const Problem& problem, double dt, double damping, State& state,
                               SinglePhaseWorkspace& work)
{
    Particles& particles = state.particles;
    timed(work.timers, Phase::sort, [&] { locate_particles(problem, dt, state, work); });
    timed(work.timers, Phase::scatter, [&] {
        const StressOnNodes stress(problem, work.volume_lists(), work.cell_strain, particles);
        scatter_to_nodes(problem, dt, state, work);
    });
    timed(work.timers, Phase::momentum, [&] {
        const bool shaking = state.stage == Stage::shaking;
        const double acceleration = shaking ? base_acceleration(problem.base_motion, state.time) : 0.0;
        const double velocity_dt = velocity_interval(state, dt);
        assemble_walls(problem, velocity_dt, work.sums, work);
        if (work.inertia) {
            solve_resisted(problem, dt, velocity_dt, acceleration, damping, state, work);
        } else {
            if (damping > 0.0) leave_unbalanced_forces(problem, acceleration, work.walls, work.sums);
            solve_single_phase_velocities(problem, velocity_dt, acceleration, damping, work);
        }
        if (state.balance_terms) {
            const double skeleton = enter_nodes(problem, work.balance_nodes, velocity_dt, acceleration,
                                                working_of(dt, velocity_dt, work), work.sums, work.outer,
                                                work.motion, *state.balance_terms);
            if (work.walls.moves)
                enter_moving_walls(problem, velocity_dt, acceleration, working_of(dt, velocity_dt, work),
                                   work.sums, work.motion, work.walls.rows, work.walls.changes,
                                   *state.balance_terms);
            if (work.inertia && !work.walls.keeps_water) work.work_of_nodes = skeleton;
        }
        spread_tied_motion(work.conditions, work.motion);
    });
    timed(work.timers, Phase::gather, [&] {
        const double fraction = dt / (dt + work.null_space_time);
        for_each_tile(work.lists, [&](const Tile& tile) {
            gather_single_phase(problem, fraction, work.lists, tile, work.stencils_of(tile), work.motion,
                                particles, work.grid_velocity);
        });
    });
    if (work.walls.keeps_water)
        timed(work.timers, Phase::pore_pressure, [&] {
            advance_pore_pressure(problem, dt, work.lists_with_pressure(), work.pressure_increment, particles,
                                  work.cell_means, [&](const Tile& tile) {
                                      undrained_increments(problem, dt, work.lists_of_kept_volume(), tile,
                                                           particles, work.pressure_increment);
                                  });
        });
    timed(work.timers, Phase::motion, [&] {
        const auto velocity = [&](std::size_t i) { return Vector2(work.motion[i].x, work.motion[i].y); };
        // undrained waves are far faster than any deformation
        if (problem.strain == StrainForm::large && !work.walls.keeps_water)
            damp_null_space_of_deformation(dt, work.masses.inertia, work.grid_velocity,
                                           work.null_space_damping, particles);
        if (state.balance_terms) enter_exchange(problem, dt, particles, *state.balance_terms);
        move_particles(problem, dt, work.grid_velocity, velocity, state);
    });
    timed(work.timers, Phase::stress, [&] { update_stresses(problem, dt, work, state); });
    carry_slivers(problem, work.places, state);
    state.time += dt;
    state.last_step = dt;
    ++state.step;
}

} // namespace quicksand
