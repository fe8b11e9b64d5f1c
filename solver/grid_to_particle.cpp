#include "solver/grid_to_particle.hpp"

#include "solver/time_step_control.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// The grid's motion at a particle as it is summed up.
struct LocalMotion {
    double x = 0.0, y = 0.0;                       // sum phi v_i [m/s]
    double change_x = 0.0, change_y = 0.0;         // sum phi (change of v_i) [m/s]
    double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0; // L [1/s]

    void add(const NodeWeight& w, double v_x, double v_y, double dv_x, double dv_y)
    {
        x += w.value * v_x;
        y += w.value * v_y;
        change_x += w.value * dv_x;
        change_y += w.value * dv_y;
        xx += w.gradient_x * v_x;
        xy += w.gradient_y * v_x;
        yx += w.gradient_x * v_y;
        yy += w.gradient_y * v_y;
    }
};

void store_gradient(const LocalMotion& local, std::size_t p, Gradients& gradient)
{
    gradient.xx[p] = local.xx;
    gradient.xy[p] = local.xy;
    gradient.yx[p] = local.yx;
    gradient.yy[p] = local.yy;
}

/// The particle's own velocity with the grid's change, its noise less the share.
Vector2 updated_velocity(const Vector2& own, const LocalMotion& local, double share)
{
    const Vector2 carried = own + Vector2(local.change_x, local.change_y);
    return carried + share * (Vector2(local.x, local.y) - carried);
}

template <class Motion, class Add>
void for_each_node(const StoredPatch& patch, const NodeWeight* weights, std::int32_t nodes_x,
                   const Motion* motion, Add&& add)
{
    for (std::int32_t b = 0; b < patch.height; ++b) {
        const Motion* row = motion + patch.base + b * nodes_x;
        for (std::int32_t a = 0; a < patch.width; ++a, ++weights) add(row[a], *weights);
    }
}

/// Draw the relative velocity towards the grid's, keeping the momentum of both phases together.
void filter_relative_velocity(const Problem& problem, double dt, std::size_t p,
                              const Vector2& relative_of_grid, Particles& particles)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    const double n = particles.porosity[p];
    const double r_s = particles.mass_solid[p] / particles.volume[p], r_w = n * problem.water->density;
    const double rate = drag_coefficient(material, *problem.water, n) * (1.0 / r_s + 1.0 / r_w);
    const double share = rate * dt / (1.0 + rate * dt);
    const Vector2 relative = particles.velocity_fluid[p] - particles.velocity_solid[p];
    const Vector2 correction = share * (relative_of_grid - relative);
    particles.velocity_fluid.set(p, particles.velocity_fluid[p] + r_s / (r_s + r_w) * correction);
    particles.velocity_solid.set(p, particles.velocity_solid[p] - r_w / (r_s + r_w) * correction);
}

} // namespace

double noise_time(const Problem& problem)
{
    constexpr double cells_of_memory = 20.0; // the fastest wave crosses in tau [-]
    double fastest = 0.0;
    for (const Material& material : problem.materials) {
        const WaveSpeeds speeds = wave_speeds(material, problem.water, material.porosity);
        fastest = std::max({fastest, speeds.fast, speeds.skeleton});
    }
    return cells_of_memory * problem.grid.cell_size / fastest;
}

void gather_two_phase(const Problem& problem, double dt, double share, const CellLists& lists,
                      const Tile& tile, const PatchStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Vectors& grid_velocity, Scalars& flux_divergence)
{
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        LocalMotion solid, fluid;
        double divergence = 0.0;
        for_each_node(*patch, store.weights.data() + patch->first, problem.grid.nodes_x(), motion.data(),
                      [&](const TwoPhaseMotion& node, const NodeWeight& w) {
                          solid.add(w, node.solid_x, node.solid_y, node.solid_change_x, node.solid_change_y);
                          fluid.add(w, node.fluid_x, node.fluid_y, node.fluid_change_x, node.fluid_change_y);
                          divergence += w.gradient_x * node.flux_x + w.gradient_y * node.flux_y;
                      });
        grid_velocity.set(p, {solid.x, solid.y});
        particles.velocity_solid.set(p, updated_velocity(particles.velocity_solid[p], solid, share));
        particles.velocity_fluid.set(p, updated_velocity(particles.velocity_fluid[p], fluid, share));
        filter_relative_velocity(problem, dt, p, Vector2(fluid.x - solid.x, fluid.y - solid.y), particles);
        store_gradient(solid, p, particles.velocity_gradient_solid);
        store_gradient(fluid, p, particles.velocity_gradient_fluid);
        flux_divergence[p] = divergence;
    }
}

void gather_single_phase(const Problem& problem, double share, const CellLists& lists, const Tile& tile,
                         const PatchStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles, Vectors& grid_velocity)
{
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        LocalMotion solid;
        for_each_node(*patch, store.weights.data() + patch->first, problem.grid.nodes_x(), motion.data(),
                      [&](const SinglePhaseMotion& node, const NodeWeight& w) {
                          solid.add(w, node.x, node.y, node.change_x, node.change_y);
                      });
        grid_velocity.set(p, {solid.x, solid.y});
        particles.velocity_solid.set(p, updated_velocity(particles.velocity_solid[p], solid, share));
        store_gradient(solid, p, particles.velocity_gradient_solid);
    }
}

} // namespace quicksand
