#include "solver/measure/particle_quantities.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/run/settling_problem.hpp"
#include "solver/run/settling_watch.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/single_phase_step.hpp"

#include <cstdint>
#include <limits>
#include <string_view>
#include <variant>

namespace quicksand {

namespace {

constexpr std::int64_t steps_between_checks = 50;

UnbalancedForces forces_of(const Problem& problem, const SinglePhaseWorkspace& work)
{
    return unbalanced_forces(problem, 0.0, work.conditions, work.walls, work.sums);
}

UnbalancedForces present_forces(const Problem& problem, const State& state)
{
    State copy = state;
    SinglePhaseWorkspace work = make_single_phase_workspace(problem, Stage::relaxation);
    copy.stage = Stage::relaxation;
    locate_particles(problem, 0.0, copy, work);
    scatter_to_nodes(problem, 0.0, copy, work);
    constexpr double unit_time = 1.0; // forces stand for impulses
    assemble_walls(problem, unit_time, work.sums, work);
    return forces_of(problem, work);
}

/// After a step. A damped step has taken the reactions of walls out of its sums, without which nothing would
/// stand for the weight where there is no gravity.
UnbalancedForces forces_after_step(const Problem& problem, const State& state,
                                   const SinglePhaseWorkspace& work)
{
    return problem.gravity > 0.0 ? forces_of(problem, work) : present_forces(problem, state);
}

/// Pores keep their pressure while soil settles: let it be that of the water at the start of the shaking.
void sink_water_table(const Problem& problem, Particles& particles)
{
    const double weight = problem.water ? problem.water->density * problem.gravity : 0.0; // [N/m3]
    if (weight <= 0.0) return;
    const auto total_head = [&](double y) { return y + static_water_pressure(problem, y) / weight; };
    for (std::size_t p = 0; p < particles.water_table.size(); ++p) {
        if (!problem.materials[static_cast<std::size_t>(particles.material[p])].saturated) continue;
        particles.water_table[p] +=
            total_head(particles.position.y[p]) - total_head(particles.reference_position.y[p]);
    }
}

std::size_t count_at_failure(const Problem& problem, const Particles& particles)
{
    std::size_t count = 0;
    for_each_material_run(problem, particles, 0, particles.size(),
                          [&](const Material& material, std::size_t first, std::size_t last) {
                              count += count_at_failure(material.law, first, last, particles);
                          });
    return count;
}

/// begin_shaking() of the body alone, without the columns of free fields.
std::size_t begin_with_memory(const Problem& problem, State& state)
{
    std::size_t limited = 0;
    add_memory(state.particles, memory_columns(problem));
    for_each_material_run(problem, state.particles, 0, state.particles.size(),
                          [&](const Material& material, std::size_t first, std::size_t last) {
                              limited += start_memory(material.law, first, last, state.particles);
                          });
    sink_water_table(problem, state.particles);
    begin_shaking(state);
    return limited;
}

} // namespace

double out_of_balance(const Problem& problem, const State& state)
{
    return present_forces(problem, state).of_weight;
}

namespace {

/// Sand bears at least the shear stress that the weight of so many cells allows.
Problem settling_problem(const Problem& problem, double cells)
{
    Problem settling = problem;
    if (settles_undrained(problem)) settling.water->flow = WaterFlow::undrained;
    for (Material& material : settling.materials) {
        const double buoyancy = water_of(problem, material) ? problem.water->density : 0.0;
        const double cell_weight = (1.0 - material.porosity) * (material.grain_density - buoyancy) *
                                   problem.gravity * problem.grid.cell_size * cells;
        material.law = settling_form(material.law, cell_weight);
        if (std::holds_alternative<SettlingSand>(material.law))
            material.volumetric_strain = VolumetricStrain::cell;
    }
    return settling;
}

/// Take part of the velocities away, in every step the same part: unlike local damping, whose sense jumps
/// with that of the velocity, this does not amplify differences of rounding.
void brake(Particles& particles)
{
    constexpr double kept = 0.9; // from step to step [-]
    for_each_array(particles, [&](const char* name, Scalars& values) {
        if (std::string_view(name).find("velocity") == std::string_view::npos) return;
        for (double& value : values) value *= kept;
    });
}

/// Whether the soil rests and is to settle on with the strength of the shaking: as it does when a run is
/// stopped there and goes on.
bool rests(const State& state)
{
    return state.stage == Stage::relaxation && state.step > 0 && state.last_step == 0.0;
}

/// Settle on, from rest, with the strength of the shaking, which near the surface is less: then nothing moves
/// when the shaking begins. First with local damping, by which soil that cannot stand at this strength runs
/// away, then to a small part of the tolerance. Corners that creep on are left; what is out of balance after
/// the last step is told. False after a stop: the state is that at the beginning again.
bool settle_at_strength(const Problem& shaken, const RelaxationControls& controls, State& state,
                        RelaxationReport& report, const StopRule& stop)
{
    constexpr std::int64_t most_steps = 4000;  // of either kind
    constexpr double share_of_tolerance = 0.1; // what moves is a small part of the body
    const State beginning = state;
    const Problem problem = problem_at_strength(shaken);
    SinglePhaseWorkspace work = make_single_phase_workspace(problem, Stage::relaxation);
    RelaxationControls endless = controls;
    endless.max_steps = std::numeric_limits<std::int64_t>::max();
    constexpr double share_of_corners = 0.05; // of the particles, which may creep on [-]
    SettlingWatch watch(problem, endless, state.particles, share_of_corners);
    bool stopped = false;
    const auto settle = [&](double tolerance, auto&& advance, auto&& look) {
        for (std::int64_t step = 1; step <= most_steps && !stopped; ++step) {
            const double dt = stable_relaxation_step(problem, state.particles).dt;
            advance(dt);
            if (step % steps_between_checks != 0) continue;
            check_particles(dt, state);
            report.unbalanced = forces_after_step(problem, state, work);
            report.steps = state.step;
            if (report.unbalanced.of_weight <= tolerance) break;
            look(dt);
            stopped = stop && stop();
        }
        set_at_rest(state.particles);
        state.last_step = 0.0;
    };
    settle(
        controls.tolerance,
        [&](double dt) { advance_single_phase_step(problem, dt, controls.damping, state, work); },
        [&](double dt) { watch.look(state, report.unbalanced, dt); });
    const auto advance_braked = [&](double dt) {
        advance_single_phase_step(problem, dt, 0.0, state, work);
        brake(state.particles);
    };
    settle(share_of_tolerance * controls.tolerance, advance_braked, [](double) {});
    if (stopped) state = beginning;
    return !stopped;
}

} // namespace

Problem settling_problem(const Problem& problem)
{
    return settling_problem(problem, 1.0);
}

Problem problem_at_strength(const Problem& shaken)
{
    return settling_problem(shaken, 0.0);
}

RelaxationReport relax(const Problem& shaken, const RelaxationControls& controls, State& state,
                       const SettlingWatcher& progress, const StopRule& stop)
{
    const Problem problem = settling_problem(shaken);
    if (state.stage != Stage::relaxation) {
        state.stage = Stage::relaxation;
        state.time = 0.0;
        state.step = 0;
        state.last_step = 0.0;
        state.whole_step = 0.0;
    }
    SinglePhaseWorkspace work = make_single_phase_workspace(problem, Stage::relaxation);
    SettlingWatch watch(problem, controls, state.particles, 0.0);
    RelaxationReport report;
    while (!rests(state)) {
        const double dt = stable_relaxation_step(problem, state.particles).dt;
        advance_single_phase_step(problem, dt, controls.damping, state, work);
        if (state.step % steps_between_checks != 0) continue;
        check_particles(dt, state);
        report.unbalanced = forces_after_step(problem, state, work);
        report.steps = state.step;
        if (report.unbalanced.of_weight <= controls.tolerance) break;
        watch.look(state, report.unbalanced, dt);
        if (progress) progress({state.step, report.unbalanced});
        if (stop && stop()) return report;
    }
    set_at_rest(state.particles);
    state.last_step = 0.0;
    if (memory_columns(shaken) > 0 && !settle_at_strength(shaken, controls, state, report, stop))
        return report;
    report.settled = true;
    report.max_displacement = monitor(problem, state, {}).max_displacement;
    report.at_failure = count_at_failure(shaken, state.particles);
    set_at_rest(state.particles);
    if (state.stages_before > 0) keep_displacement(state.particles); // at first weight comes on soil as drawn
    if (problem.strain == StrainForm::small) return_to_reference(state.particles);
    for (std::size_t k = 0; k < shaken.free_fields.size(); ++k)
        relax(shaken.free_fields[k].column, controls, state.free_fields[k].column);
    begin_with_memory(shaken, state);
    return report;
}

std::size_t begin_shaking(const Problem& problem, State& state)
{
    for (std::size_t k = 0; k < problem.free_fields.size(); ++k)
        begin_shaking(problem.free_fields[k].column, state.free_fields[k].column);
    return begin_with_memory(problem, state);
}

void begin_shaking(State& state)
{
    state.stage = Stage::shaking;
    state.time = 0.0;
    state.step = 0;
    state.last_step = 0.0;
    state.whole_step = 0.0;
    reset_reference(state.particles);
    for (std::size_t p = 0; p < state.particles.water_volume.size(); ++p)
        state.particles.water_volume[p] = state.particles.porosity[p] * state.particles.volume[p];
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.initial_vertical_effective_stress[p] = -state.particles.stress.yy[p];
    }
}

} // namespace quicksand
