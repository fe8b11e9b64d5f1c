#include "solver/motion/grid_to_particle.hpp"

#include "solver/base/lanes.hpp"
#include "solver/interpolation/stencil_walk.hpp"
#include "solver/motion/affine_velocity.hpp"
#include "solver/problem/wave_speeds.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// The grid's motion at a particle of a body that moves as one: lanes v and its change, as SinglePhaseMotion.
struct LocalMotion {
    Lanes motion;            // [m/s]
    LaneGradients gradients; // of the motion
    LaneGradients affine;
};

inline LocalMotion motion_at(const BackgroundGrid& grid, const StoredStencil& stencil,
                             const StencilStore& store, const SinglePhaseMotion* motion)
{
    LaneGradients gradients = {all_lanes(0.0), all_lanes(0.0)};
    MotionFit fit;
    walk_stencil(
        stencil, store, grid.nodes_x(), motion, [&] { fit.begin_row(); },
        [&](const SinglePhaseMotion& node, double phi, double grad_x, double grad_y) {
            const Lanes at_node = load_lanes(&node.x);
            fit.add(phi, at_node);
            gradients.x += grad_x * at_node;
            gradients.y += grad_y * at_node;
        },
        [&] { fit.end_row(); });
    return {fit.mean(), gradients, fit.gradients(grid.cell_size)};
}

/// The motion of both phases at a particle: lanes v_s and v_w, as TwoPhaseMotion.
struct LocalTwoPhaseMotion {
    Lanes velocity, change;  // [m/s]
    LaneGradients gradients; // lanes flux and v_s
    LaneGradients affine;
};

inline LocalTwoPhaseMotion motion_at(const BackgroundGrid& grid, const StoredStencil& stencil,
                                     const StencilStore& store, const TwoPhaseMotion* motion)
{
    Lanes change = all_lanes(0.0);
    LaneGradients gradients = {change, change};
    MotionFit fit;
    walk_stencil(
        stencil, store, grid.nodes_x(), motion, [&] { fit.begin_row(); },
        [&](const TwoPhaseMotion& node, double phi, double grad_x, double grad_y) {
            fit.add(phi, load_lanes(&node.solid_x));
            change += phi * load_lanes(&node.solid_change_x);
            const Lanes flux_and_solid = load_lanes(&node.flux_x);
            gradients.x += grad_x * flux_and_solid;
            gradients.y += grad_y * flux_and_solid;
        },
        [&] { fit.end_row(); });
    return {fit.mean(), change, gradients, fit.gradients(grid.cell_size)};
}

/// Lanes k and k + 1 are the components of one velocity along x and y.
inline void store_gradients(const LaneGradients& gradients, int k, std::size_t p, Gradients& L)
{
    L.xx[p] = gradients.x[k], L.xy[p] = gradients.y[k];
    L.yx[p] = gradients.x[k + 1], L.yy[p] = gradients.y[k + 1];
}

/// Moves the relative velocity of a particle towards the grid's: the water's velocity changes by fluid times
/// the difference, the grains' by -solid times it; the total momentum stays.
struct RelativeFilter {
    double solid, fluid; // [-]
};

/// a dt / (1 + a dt), a = C (1/r_s + 1/r_w), divided in proportion to the mass of the other phase; zero
/// without water. With r_s = m/V and C = c/k it is one fraction.
inline RelativeFilter relative_filter(const Problem& problem, double dt, const Particles& particles,
                                      std::size_t p)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    if (!material.saturated) return {0.0, 0.0};
    const double n = particles.porosity[p], m_s = particles.mass_solid[p];
    const double r_w = n * problem.water->density, m_w = r_w * particles.volume[p];
    const double k = hydraulic_conductivity(material, particles, p),
                 dt_c = dt * drag_weight(material, *problem.water, n);
    const double fraction = dt_c / (k * r_w * m_s + dt_c * (m_s + m_w));
    return {fraction * m_w, fraction * m_s};
}

/// The particle's velocities plus the change of the grid's, with theta = `fraction` and the relative filter.
inline Lanes updated_velocities(const Particles& particles, std::size_t p, const LocalTwoPhaseMotion& local,
                                double fraction, const RelativeFilter& filter)
{
    const Lanes own = {particles.velocity_solid.x[p], particles.velocity_solid.y[p],
                       particles.velocity_fluid.x[p], particles.velocity_fluid.y[p]};
    const Lanes carried = own + local.change;
    const Lanes v = carried + fraction * (local.velocity - carried);
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
    store_gradients(local.gradients, 2, p, particles.velocity_gradient_solid);
    store_gradients(local.affine, 0, p, particles.affine_velocity_solid);
    store_gradients(local.affine, 2, p, particles.affine_velocity_fluid);
}

} // namespace

double null_space_time(const Problem& problem)
{
    constexpr double cells_of_memory = 20.0; // the fastest wave crosses in tau [-]
    double fastest = 0.0;
    const bool soil_alone = has_soil_and_solids(problem);
    for (const Material& material : problem.materials) {
        if (soil_alone && !material.has_pores) continue; // stiff solids would have the soil forget sooner
        const WaveSpeeds speeds = wave_speeds(material, water_of(problem, material), material.porosity);
        fastest = std::max(fastest, fastest_speed(problem, speeds));
    }
    return cells_of_memory * problem.grid.cell_size / fastest;
}

VECTOR_KERNEL
void gather_two_phase(const Problem& problem, double dt, double fraction, const CellLists& lists,
                      const Tile& tile, const StencilStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Vectors& grid_velocity, Scalars& flux_divergence)
{
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++stencil) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const LocalTwoPhaseMotion local = motion_at(problem.grid, *stencil, store, motion.data());
        const RelativeFilter filter = relative_filter(problem, dt, particles, p);
        store_motion(local, updated_velocities(particles, p, local, fraction, filter), p, particles);
        grid_velocity.x[p] = local.velocity[0];
        grid_velocity.y[p] = local.velocity[1];
        flux_divergence[p] = local.gradients.x[0] + local.gradients.y[1];
    }
}

VECTOR_KERNEL
void gather_single_phase(const Problem& problem, double fraction, const CellLists& lists, const Tile& tile,
                         const StencilStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles, Vectors& grid_velocity)
{
    Vectors& velocity = particles.velocity_solid;
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++stencil) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const LocalMotion local = motion_at(problem.grid, *stencil, store, motion.data());
        grid_velocity.x[p] = local.motion[0];
        grid_velocity.y[p] = local.motion[1];
        // the particle's velocity plus the change of the grid's, with theta = `fraction`
        const double x = velocity.x[p] + local.motion[2], y = velocity.y[p] + local.motion[3];
        velocity.x[p] = x + fraction * (local.motion[0] - x);
        velocity.y[p] = y + fraction * (local.motion[1] - y);
        store_gradients(local.gradients, 0, p, particles.velocity_gradient_solid);
        store_gradients(local.affine, 0, p, particles.affine_velocity_solid);
    }
}

} // namespace quicksand
