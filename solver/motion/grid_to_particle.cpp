#include "solver/motion/grid_to_particle.hpp"

#include "solver/base/lanes.hpp"
#include "solver/interpolation/patch_walk.hpp"
#include "solver/motion/carried_slope.hpp"
#include "solver/problem/wave_speeds.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// The grid's motion at a particle of a body that moves as one: lanes v and its change, as SinglePhaseMotion.
struct LocalMotion {
    Lanes motion;     // [m/s]
    Slopes gradients; // of the motion
    Slopes carried;
};

inline LocalMotion motion_at(const BackgroundGrid& grid, const StoredPatch& patch, const PatchStore& store,
                             const SinglePhaseMotion* motion)
{
    Slopes gradients = {all_lanes(0.0), all_lanes(0.0)};
    MotionFit fit;
    walk_patch(
        patch, store, grid.nodes_x(), motion, [&] { fit.begin_row(); },
        [&](const SinglePhaseMotion& node, double phi, double grad_x, double grad_y) {
            const Lanes at_node = load_lanes(&node.x);
            fit.add(phi, at_node);
            gradients.x += grad_x * at_node;
            gradients.y += grad_y * at_node;
        },
        [&] { fit.end_row(); });
    return {fit.mean(), gradients, fit.slopes(grid.cell_size)};
}

/// The motion of both phases at a particle: lanes v_s and v_w, as TwoPhaseMotion.
struct LocalTwoPhaseMotion {
    Lanes velocity, change; // [m/s]
    Slopes gradients;       // lanes flux and v_s
    Slopes carried;
};

inline LocalTwoPhaseMotion motion_at(const BackgroundGrid& grid, const StoredPatch& patch,
                                     const PatchStore& store, const TwoPhaseMotion* motion)
{
    Lanes change = all_lanes(0.0);
    Slopes gradients = {change, change};
    MotionFit fit;
    walk_patch(
        patch, store, grid.nodes_x(), motion, [&] { fit.begin_row(); },
        [&](const TwoPhaseMotion& node, double phi, double grad_x, double grad_y) {
            fit.add(phi, load_lanes(&node.solid_x));
            change += phi * load_lanes(&node.solid_change_x);
            const Lanes flux_and_solid = load_lanes(&node.flux_x);
            gradients.x += grad_x * flux_and_solid;
            gradients.y += grad_y * flux_and_solid;
        },
        [&] { fit.end_row(); });
    return {fit.mean(), change, gradients, fit.slopes(grid.cell_size)};
}

/// Lanes k and k + 1 of the slopes are those of one velocity along x and y.
inline void store_slopes(const Slopes& slopes, int k, std::size_t p, Gradients& L)
{
    L.xx[p] = slopes.x[k], L.xy[p] = slopes.y[k];
    L.yx[p] = slopes.x[k + 1], L.yy[p] = slopes.y[k + 1];
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
    store_slopes(local.gradients, 2, p, particles.velocity_gradient_solid);
    store_slopes(local.carried, 0, p, particles.velocity_slope_solid);
    store_slopes(local.carried, 2, p, particles.velocity_slope_fluid);
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
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const LocalTwoPhaseMotion local = motion_at(problem.grid, *patch, store, motion.data());
        const RelativeFilter filter = relative_filter(problem, dt, particles, p);
        store_motion(local, updated_velocities(particles, p, local, share, filter), p, particles);
        grid_velocity.x[p] = local.velocity[0];
        grid_velocity.y[p] = local.velocity[1];
        flux_divergence[p] = local.gradients.x[0] + local.gradients.y[1];
    }
}

VECTOR_KERNEL
void gather_single_phase(const Problem& problem, double share, const CellLists& lists, const Tile& tile,
                         const PatchStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles, Vectors& grid_velocity)
{
    Vectors& velocity = particles.velocity_solid;
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const LocalMotion local = motion_at(problem.grid, *patch, store, motion.data());
        grid_velocity.x[p] = local.motion[0];
        grid_velocity.y[p] = local.motion[1];
        // the particle's own velocity with the grid's change, its noise less the share
        const double x = velocity.x[p] + local.motion[2], y = velocity.y[p] + local.motion[3];
        velocity.x[p] = x + share * (local.motion[0] - x);
        velocity.y[p] = y + share * (local.motion[1] - y);
        store_slopes(local.gradients, 0, p, particles.velocity_gradient_solid);
        store_slopes(local.carried, 0, p, particles.velocity_slope_solid);
    }
}

} // namespace quicksand
