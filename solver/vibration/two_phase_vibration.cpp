#include "solver/vibration/two_phase_vibration.hpp"

#include "solver/base/threads.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/motion/grid_to_particle.hpp"
#include "solver/vibration/cell_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// The drag C' - C'' that acts on a motion which changes its sign in every step, see centre_drag.
void set_alternating_drag(double dt, double strong, std::vector<TwoPhaseSums>& sums)
{
    for_each_index(sums.size(), [&](std::size_t i) {
        TwoPhaseSums& node = sums[i];
        if (!node.active() || !(node.drag > 0.0)) return;
        const double mobility = dt * (1.0 / node.mass_solid + 1.0 / node.mass_fluid);
        for (double* drag : {&node.drag_1, &node.drag_2})
            *drag *= 1.0 - 2.0 * std::min(0.5, strong / (mobility * *drag));
    });
}

void set_at_rest(std::vector<TwoPhaseSums>& sums)
{
    for_each_index(sums.size(), [&](std::size_t i) {
        TwoPhaseSums& node = sums[i];
        node.momentum_solid_x = node.momentum_solid_y = 0.0;
        node.momentum_fluid_x = node.momentum_fluid_y = 0.0;
        node.drag_force_x = node.drag_force_y = 0.0;
    });
}

} // namespace

TwoPhaseEquations::TwoPhaseEquations(const Problem& problem, const State& state, double dt)
    : problem_(problem), small_(form_of_small_motion(problem)), state_(resting_copy(state)),
      half_step_(0.5 * dt), work_(make_semi_implicit_workspace(small_))
{
    Particles& particles = state_.particles;
    work_.flux_divergence.resize(particles.size());
    locate_particles(problem_, dt, state_, work_);
    scatter_to_nodes(problem_, dt, state_.time, state_, work_);
    moduli_ = tangent_moduli(problem_, particles); // of the particles in their new order
    work_.dashpots.clear();                        // alternating motion has no mean velocity to be braked
    particles.pore_pressure.assign(particles.size(), 0.0);
    particles.pore_pressure_rate.assign(particles.size(), 0.0);
    set_at_rest(work_.sums);
    set_alternating_drag(dt, is_semi_implicit() ? semi_implicit_strong_drag : explicit_strong_drag,
                         work_.sums);
    assemble_walls(problem_, half_step_, work_.sums, work_);
    restoring_.resize(work_.sums.size());
}

Scalars TwoPhaseEquations::root_masses() const
{
    Scalars roots(components * work_.sums.size(), 0.0);
    for (std::size_t i = 0; i < work_.sums.size(); ++i) {
        roots[components * i] = roots[components * i + 1] = std::sqrt(work_.sums[i].mass_solid);
        if (is_semi_implicit()) continue;
        roots[components * i + 2] = roots[components * i + 3] = std::sqrt(work_.sums[i].mass_fluid);
    }
    for (const TiedNodes& tie : work_.conditions.tied)
        std::fill_n(roots.begin() + static_cast<std::ptrdiff_t>(components * tie.node), components, 0.0);
    return roots;
}

void TwoPhaseEquations::deform(const Scalars& velocity, Scalars& force)
{
    for_each_index(work_.motion.size(), [&](std::size_t i) {
        const double* v = &velocity[components * i];
        work_.motion[i] = {.flux_x = v[2], .flux_y = v[3], .solid_x = v[0], .solid_y = v[1]};
    });
    Particles& particles = state_.particles;
    for_each_tile(work_.lists, [&](const Tile& tile) {
        gather_two_phase(problem_, 0.0, 0.0, work_.lists, tile, work_.stencils_of(tile), work_.motion,
                         particles, work_.grid_velocity, work_.flux_divergence);
    });
    if (!is_semi_implicit())
        set_restoring_pressure(
            problem_, work_.lists_with_pressure(), [&](std::size_t p) { return work_.flux_divergence[p]; },
            particles);
    average_volume_change(work_.volume_lists(), work_.cell_strain.averaged, particles);
    set_restoring_stress(moduli_, particles);
    set_to_zero(restoring_);
    for_each_tile_by_colour(work_.lists, [&](const Tile& tile) {
        scatter_two_phase(problem_, particles, work_.lists, tile, work_.stencils_of(tile), restoring_);
    });
    gather_tied_sums(work_.conditions, restoring_);
    for (const TiedNodes& tie : work_.conditions.tied) restoring_[tie.node] = {};
    for_each_index(restoring_.size(), [&](std::size_t i) {
        const TwoPhaseSums& node = restoring_[i];
        double* f = &force[components * i];
        f[0] = node.stress_force_x, f[1] = node.stress_force_y;
        f[2] = node.pressure_force_x, f[3] = node.pressure_force_y;
    });
}

void TwoPhaseEquations::solve_velocities()
{
    const auto solve = [&] {
        solve_two_phase_momentum(small_, work_.conditions, half_step_, 0.0, work_.sums, work_.motion);
        rest_at_walls(problem_, work_.sums, work_.walls, work_.motion);
        spread_tied_motion(work_.conditions, work_.motion);
    };
    solve();
    if (!is_semi_implicit()) return;
    // dp with n V / K_w where the step solves for x with n V / (b K_w)
    prepare_pressure(problem_, half_step_ / acting_weight, half_step_, state_.particles, work_);
    find_increments(problem_, half_step_ / acting_weight, half_step_, state_, work_);
    solve();
}

void TwoPhaseEquations::keep_lost_momenta()
{
    Particles& particles = state_.particles;
    for_each_tile(work_.lists, [&](const Tile& tile) {
        gather_two_phase(problem_, 0.0, 1.0, work_.lists, tile, work_.stencils_of(tile), work_.motion,
                         particles, work_.grid_velocity, work_.flux_divergence);
    });
    set_to_zero(restoring_);
    for_each_tile_by_colour(work_.lists, [&](const Tile& tile) {
        scatter_two_phase(problem_, particles, work_.lists, tile, work_.stencils_of(tile), restoring_);
    });
    gather_tied_sums(work_.conditions, restoring_);
    for_each_index(work_.sums.size(), [&](std::size_t i) {
        TwoPhaseSums& node = work_.sums[i];
        const TwoPhaseMotion& motion = work_.motion[i];
        const TwoPhaseSums& kept = restoring_[i];
        node.momentum_solid_x = node.mass_solid * motion.solid_x - kept.momentum_solid_x;
        node.momentum_solid_y = node.mass_solid * motion.solid_y - kept.momentum_solid_y;
        node.momentum_fluid_x = node.mass_fluid * motion.fluid_x - kept.momentum_fluid_x;
        node.momentum_fluid_y = node.mass_fluid * motion.fluid_y - kept.momentum_fluid_y;
        node.stress_force_x = node.stress_force_y = 0.0;
        node.pressure_force_x = node.pressure_force_y = 0.0;
    });
}

void TwoPhaseEquations::respond(const Scalars& force, Scalars& velocity)
{
    set_at_rest(work_.sums);
    for_each_index(work_.sums.size(), [&](std::size_t i) {
        const double* f = &force[components * i];
        work_.sums[i].stress_force_x = f[0], work_.sums[i].stress_force_y = f[1];
        work_.sums[i].pressure_force_x = f[2], work_.sums[i].pressure_force_y = f[3];
    });
    // the step answers dt/2 f with (R + dt/2 C J + (dt/2)^2 Q)^-1 dt/2 f
    solve_velocities();
    const double scale = 1.0 / (4.0 * half_step_);
    std::fill(velocity.begin(), velocity.end(), 0.0);
    const auto add = [&] {
        for_each_index(work_.motion.size(), [&](std::size_t i) {
            const TwoPhaseMotion& node = work_.motion[i];
            double* v = &velocity[components * i];
            v[0] += scale * node.solid_x, v[1] += scale * node.solid_y;
            v[2] += scale * node.flux_x, v[3] += scale * node.flux_y;
        });
    };
    add();
    keep_lost_momenta();
    solve_velocities();
    add();
}

} // namespace quicksand
