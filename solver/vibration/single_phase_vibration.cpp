#include "solver/vibration/single_phase_vibration.hpp"

#include "solver/base/threads.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/motion/grid_to_particle.hpp"
#include "solver/vibration/cell_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double any_step = 1.0; // [s]

} // namespace

SinglePhaseEquations::SinglePhaseEquations(const Problem& problem, const State& state)
    : problem_(problem), small_(form_of_small_motion(problem)), state_(resting_copy(state)),
      work_(make_single_phase_workspace(problem))
{
    locate_particles(problem_, any_step, state_, work_);
    scatter_to_nodes(problem_, any_step, state_, work_);
    moduli_ = tangent_moduli(problem_, state_.particles); // of the particles in their new order
    work_.dashpots.clear(); // alternating motion has no mean velocity to be braked
    for (SinglePhaseSums& node : work_.sums) node.momentum_x = node.momentum_y = 0.0;
    assemble_walls(problem_, any_step, work_.sums, work_);
    restoring_.resize(work_.sums.size());
}

Scalars SinglePhaseEquations::root_masses() const
{
    Scalars roots(components * work_.sums.size(), 0.0);
    for (std::size_t i = 0; i < work_.sums.size(); ++i)
        roots[components * i] = roots[components * i + 1] = std::sqrt(work_.sums[i].mass);
    for (const TiedNodes& tie : work_.conditions.tied)
        std::fill_n(roots.begin() + static_cast<std::ptrdiff_t>(components * tie.node), components, 0.0);
    return roots;
}

void SinglePhaseEquations::deform(const Scalars& velocity, Scalars& force)
{
    for_each_index(work_.motion.size(), [&](std::size_t i) {
        work_.motion[i] = {velocity[components * i], velocity[components * i + 1], 0.0, 0.0};
    });
    Particles& particles = state_.particles;
    const Gradients& L = particles.velocity_gradient_solid;
    for_each_tile(work_.lists, [&](const Tile& tile) {
        gather_single_phase(problem_, 0.0, work_.lists, tile, work_.stencils_of(tile), work_.motion,
                            particles, work_.grid_velocity);
    });
    if (work_.walls.keeps_water)
        set_restoring_pressure(
            problem_, work_.lists_of_kept_volume(), [&](std::size_t p) { return L.xx[p] + L.yy[p]; },
            particles);
    average_volume_change(work_.volume_lists(), work_.cell_strain.averaged, particles);
    set_restoring_stress(moduli_, particles);
    set_to_zero(restoring_);
    const auto scatter = work_.walls.keeps_water ? scatter_total_stress : scatter_single_phase;
    for_each_tile_by_colour(work_.lists, [&](const Tile& tile) {
        scatter(problem_, particles, work_.masses, work_.lists, tile, work_.stencils_of(tile), restoring_);
    });
    gather_tied_sums(work_.conditions, restoring_);
    for (const TiedNodes& tie : work_.conditions.tied) restoring_[tie.node] = {};
    for_each_index(restoring_.size(), [&](std::size_t i) {
        force[components * i] = restoring_[i].stress_force_x;
        force[components * i + 1] = restoring_[i].stress_force_y;
    });
}

void SinglePhaseEquations::solve_velocities()
{
    solve_single_phase_momentum(small_, work_.conditions, any_step, 0.0, 0.0, work_.sums, work_.motion);
    rest_at_walls(work_.walls, work_.motion);
    spread_tied_motion(work_.conditions, work_.motion);
}

void SinglePhaseEquations::keep_lost_momenta()
{
    Particles& particles = state_.particles;
    for_each_tile(work_.lists, [&](const Tile& tile) {
        gather_single_phase(problem_, 1.0, work_.lists, tile, work_.stencils_of(tile), work_.motion,
                            particles, work_.grid_velocity);
    });
    set_to_zero(restoring_);
    for_each_tile_by_colour(work_.lists, [&](const Tile& tile) {
        scatter_single_phase(problem_, particles, work_.masses, work_.lists, tile, work_.stencils_of(tile),
                             restoring_);
    });
    gather_tied_sums(work_.conditions, restoring_);
    for_each_index(work_.sums.size(), [&](std::size_t i) {
        SinglePhaseSums& node = work_.sums[i];
        node.momentum_x = node.mass * work_.motion[i].x - restoring_[i].momentum_x;
        node.momentum_y = node.mass * work_.motion[i].y - restoring_[i].momentum_y;
        node.stress_force_x = node.stress_force_y = 0.0;
    });
}

void SinglePhaseEquations::respond(const Scalars& force, Scalars& velocity)
{
    for_each_index(work_.sums.size(), [&](std::size_t i) {
        SinglePhaseSums& node = work_.sums[i];
        node.momentum_x = node.momentum_y = 0.0;
        node.stress_force_x = force[components * i];
        node.stress_force_y = force[components * i + 1];
    });
    std::fill(velocity.begin(), velocity.end(), 0.0);
    const auto add = [&] {
        for_each_index(work_.motion.size(), [&](std::size_t i) {
            velocity[components * i] += 0.25 * work_.motion[i].x;
            velocity[components * i + 1] += 0.25 * work_.motion[i].y;
        });
    };
    solve_velocities();
    add();
    keep_lost_momenta();
    solve_velocities();
    add();
}

} // namespace quicksand
