#include "solver/grid_to_particle.hpp"

#include "solver/lanes.hpp"
#include "solver/patch_walk.hpp"
#include "solver/time_step_control.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// The grid's motion at a particle of a body that moves as one: lanes v and its change, as SinglePhaseMotion.
struct LocalMotion {
    Lanes motion;           // [m/s]
    Lanes slope_x, slope_y; // d/dx and d/dy of the motion [1/s]
};

inline LocalMotion motion_at(const StoredPatch& patch, const PatchStore& store, std::int32_t nodes_x,
                             const SinglePhaseMotion* motion)
{
    Lanes at_particle = all_lanes(0.0), slope_x = at_particle, slope_y = at_particle;
    walk_patch(patch, store, nodes_x, motion,
               [&](const SinglePhaseMotion& node, double phi, double grad_x, double grad_y) {
                   const Lanes at_node = load_lanes(&node.x);
                   at_particle += phi * at_node;
                   slope_x += grad_x * at_node;
                   slope_y += grad_y * at_node;
               });
    return {at_particle, slope_x, slope_y};
}

/// The motion of both phases at a particle: lanes v_s and v_w, as TwoPhaseMotion.
struct LocalTwoPhaseMotion {
    Lanes velocity, change; // [m/s]
    Lanes slope_x, slope_y; // d/dx and d/dy of the velocity [1/s]
    double divergence;      // of the flux [1/s]
};

inline LocalTwoPhaseMotion motion_at(const StoredPatch& patch, const PatchStore& store, std::int32_t nodes_x,
                                     const TwoPhaseMotion* motion)
{
    Lanes velocity = all_lanes(0.0), change = velocity, slope_x = velocity, slope_y = velocity;
    double divergence = 0.0;
    walk_patch(patch, store, nodes_x, motion,
               [&](const TwoPhaseMotion& node, double phi, double grad_x, double grad_y) {
                   const Lanes at_node = load_lanes(&node.solid_x);
                   velocity += phi * at_node;
                   change += phi * load_lanes(&node.solid_change_x);
                   slope_x += grad_x * at_node;
                   slope_y += grad_y * at_node;
                   divergence += grad_x * node.flux_x + grad_y * node.flux_y;
               });
    return {velocity, change, slope_x, slope_y, divergence};
}

/// What draws the relative velocity of a particle towards the grid's: the correction of the water is
/// fluid times the difference, that of the grains minus solid times it; the momentum of both stays.
struct RelativeFilter {
    double solid, fluid; // [-]
};

/// a dt / (1 + a dt), a = C (1/r_s + 1/r_w), shared out by the masses of the other phase; none without water.
/// With r_s = m/V and C = c/k it is one fraction.
inline RelativeFilter relative_filter(const Problem& problem, double dt, const Particles& particles,
                                      std::size_t p)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    if (!material.saturated) return {0.0, 0.0};
    const double n = particles.porosity[p], m_s = particles.mass_solid[p];
    const double r_w = n * problem.water->density, m_w = r_w * particles.volume[p];
    const double k = hydraulic_conductivity(material, n),
                 dt_c = dt * drag_weight(material, *problem.water, n);
    const double share = dt_c / (k * r_w * m_s + dt_c * (m_s + m_w));
    return {share * m_w, share * m_s};
}

/// The particle's own velocities with the grid's change, their noise less the share.
inline Lanes updated_velocities(const Particles& particles, std::size_t p, const LocalTwoPhaseMotion& local,
                                double share, const RelativeFilter& filter)
{
    const Lanes own = {particles.velocity_solid.x[p], particles.velocity_solid.y[p],
                       particles.velocity_fluid.x[p], particles.velocity_fluid.y[p]};
    const Lanes carried = own + local.change;
    const Lanes v = carried + share * (local.velocity - carried);
    const double x = (local.velocity[2] - local.velocity[0]) - (v[2] - v[0]);
    const double y = (local.velocity[3] - local.velocity[1]) - (v[3] - v[1]);
    return v + Lanes{-filter.solid * x, -filter.solid * y, filter.fluid * x, filter.fluid * y};
}

inline void store_motion(const LocalTwoPhaseMotion& local, const Lanes& velocity, std::size_t p,
                         Particles& particles)
{
    particles.velocity_solid.x[p] = velocity[0];
    particles.velocity_solid.y[p] = velocity[1];
    particles.velocity_fluid.x[p] = velocity[2];
    particles.velocity_fluid.y[p] = velocity[3];
    Gradients &Ls = particles.velocity_gradient_solid, &Lw = particles.velocity_gradient_fluid;
    Ls.xx[p] = local.slope_x[0], Ls.xy[p] = local.slope_y[0];
    Ls.yx[p] = local.slope_x[1], Ls.yy[p] = local.slope_y[1];
    Lw.xx[p] = local.slope_x[2], Lw.xy[p] = local.slope_y[2];
    Lw.yx[p] = local.slope_x[3], Lw.yy[p] = local.slope_y[3];
}

} // namespace

double noise_time(const Problem& problem)
{
    constexpr double cells_of_memory = 20.0; // the fastest wave crosses in tau [-]
    double fastest = 0.0;
    for (const Material& material : problem.materials) {
        const WaveSpeeds speeds = wave_speeds(material, water_of(problem, material), material.porosity);
        fastest = std::max(fastest, fastest_speed(problem, speeds));
    }
    return cells_of_memory * problem.grid.cell_size / fastest;
}

VECTOR_KERNEL
void gather_two_phase(const Problem& problem, double dt, double share, const CellLists& lists,
                      const Tile& tile, const PatchStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Vectors& grid_velocity, Scalars& flux_divergence)
{
    const std::int32_t nodes_x = problem.grid.nodes_x();
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const LocalTwoPhaseMotion local = motion_at(*patch, store, nodes_x, motion.data());
        const RelativeFilter filter = relative_filter(problem, dt, particles, p);
        store_motion(local, updated_velocities(particles, p, local, share, filter), p, particles);
        grid_velocity.x[p] = local.velocity[0];
        grid_velocity.y[p] = local.velocity[1];
        flux_divergence[p] = local.divergence;
    }
}

VECTOR_KERNEL
void gather_single_phase(const Problem& problem, double share, const CellLists& lists, const Tile& tile,
                         const PatchStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles, Vectors& grid_velocity)
{
    const std::int32_t nodes_x = problem.grid.nodes_x();
    Gradients& L = particles.velocity_gradient_solid;
    Vectors& velocity = particles.velocity_solid;
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const LocalMotion local = motion_at(*patch, store, nodes_x, motion.data());
        grid_velocity.x[p] = local.motion[0];
        grid_velocity.y[p] = local.motion[1];
        // the particle's own velocity with the grid's change, its noise less the share
        const double x = velocity.x[p] + local.motion[2], y = velocity.y[p] + local.motion[3];
        velocity.x[p] = x + share * (local.motion[0] - x);
        velocity.y[p] = y + share * (local.motion[1] - y);
        L.xx[p] = local.slope_x[0], L.xy[p] = local.slope_y[0];
        L.yx[p] = local.slope_x[1], L.yy[p] = local.slope_y[1];
    }
}

} // namespace quicksand
