#include "solver/grid_to_particle.hpp"

namespace quicksand {

namespace {

/// Velocity and its gradient as they are summed up.
struct LocalMotion {
    double x = 0.0, y = 0.0;
    double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;

    void add(const NodeWeight& w, double v_x, double v_y)
    {
        x += w.value * v_x;
        y += w.value * v_y;
        xx += w.gradient_x * v_x;
        xy += w.gradient_y * v_x;
        yx += w.gradient_x * v_y;
        yy += w.gradient_y * v_y;
    }
};

void store_motion(const LocalMotion& local, std::size_t p, Vectors& velocity, Gradients& gradient)
{
    velocity.x[p] = local.x;
    velocity.y[p] = local.y;
    gradient.xx[p] = local.xx;
    gradient.xy[p] = local.xy;
    gradient.yx[p] = local.yx;
    gradient.yy[p] = local.yy;
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

} // namespace

void gather_two_phase(const BackgroundGrid& grid, const CellLists& lists, const Tile& tile,
                      const PatchStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Scalars& flux_divergence)
{
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        LocalMotion solid, fluid;
        double divergence = 0.0;
        for_each_node(*patch, store.weights.data() + patch->first, grid.nodes_x(), motion.data(),
                      [&](const TwoPhaseMotion& node, const NodeWeight& w) {
                          solid.add(w, node.solid_x, node.solid_y);
                          fluid.add(w, node.fluid_x, node.fluid_y);
                          divergence += w.gradient_x * node.flux_x + w.gradient_y * node.flux_y;
                      });
        store_motion(solid, p, particles.velocity_solid, particles.velocity_gradient_solid);
        store_motion(fluid, p, particles.velocity_fluid, particles.velocity_gradient_fluid);
        flux_divergence[p] = divergence;
    }
}

void gather_single_phase(const BackgroundGrid& grid, const CellLists& lists, const Tile& tile,
                         const PatchStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles)
{
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        LocalMotion solid;
        for_each_node(
            *patch, store.weights.data() + patch->first, grid.nodes_x(), motion.data(),
            [&](const SinglePhaseMotion& node, const NodeWeight& w) { solid.add(w, node.x, node.y); });
        store_motion(solid, p, particles.velocity_solid, particles.velocity_gradient_solid);
    }
}

} // namespace quicksand
