#include "solver/deformation_noise.hpp"

#include "solver/threads.hpp"

#include <cmath>
#include <cstdint>

namespace quicksand {

namespace {

/// Call visit(p, patch, store) for the particles of a tile.
template <class Visit>
void for_each_particle(const CellLists& lists, const std::vector<PatchStore>& patches, const Tile& tile,
                       Visit&& visit)
{
    const PatchStore& store = patches[static_cast<std::size_t>(tile.number)];
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch)
        visit(static_cast<std::size_t>(lists.order[k]), *patch, store);
}

/// Divide the nodes' sums by their masses; tied nodes have the mean of their masters.
void take_means(const NodeConditions& conditions, const std::vector<SinglePhaseSums>& sums, Vectors& mean)
{
    for (const TiedNodes& tie : conditions.tied) {
        mean.x[tie.master] += mean.x[tie.node];
        mean.y[tie.master] += mean.y[tie.node];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!sums[i].active()) continue;
        mean.x[i] /= sums[i].mass;
        mean.y[i] /= sums[i].mass;
    }
    for (const TiedNodes& tie : conditions.tied) mean.set(tie.node, mean[tie.master]);
}

} // namespace

void fade_noise_of_deformation(double dt, const Vectors& grid_velocity, Particles& particles, Vectors& change)
{
    constexpr double fading_per_strain = 4.0; // [-]
    const Gradients& L = particles.velocity_gradient_solid;
    Vectors& velocity = particles.velocity_solid;
    change.x.resize(particles.size());
    change.y.resize(particles.size());
    const auto count = static_cast<std::int64_t>(particles.size());
#pragma omp parallel for schedule(static) if (particles.size() > least_parallel_work)
    for (std::int64_t k = 0; k < count; ++k) {
        const auto p = static_cast<std::size_t>(k);
        const double shear = 0.5 * (L.xy[p] + L.yx[p]);
        const double rate = std::sqrt(L.xx[p] * L.xx[p] + L.yy[p] * L.yy[p] + 2.0 * shear * shear);
        const double share = fading_per_strain * dt * rate / (1.0 + fading_per_strain * dt * rate);
        change.set(p, share * (grid_velocity[p] - velocity[p]));
        velocity.set(p, velocity[p] + change[p]);
    }
}

void keep_momentum(const BackgroundGrid& grid, const CellLists& lists, const std::vector<PatchStore>& patches,
                   const NodeConditions& conditions, const Scalars& mass,
                   const std::vector<SinglePhaseSums>& sums, NoiseFading& fading, Particles& particles)
{
    Vectors& mean = fading.mean;
    mean.x.assign(sums.size(), 0.0);
    mean.y.assign(sums.size(), 0.0);
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        for_each_particle(
            lists, patches, tile, [&](std::size_t p, const StoredPatch& patch, const PatchStore& store) {
                const Vector2 impulse = mass[p] * fading.change[p];
                for_each_node(patch, store, grid.nodes_x(), [&](std::size_t i, const NodeWeight& w) {
                    mean.x[i] += w.value * impulse.x();
                    mean.y[i] += w.value * impulse.y();
                });
            });
    });
    take_means(conditions, sums, mean);
    for_each_tile(lists, [&](const Tile& tile) {
        for_each_particle(
            lists, patches, tile, [&](std::size_t p, const StoredPatch& patch, const PatchStore& store) {
                Vector2 own = particles.velocity_solid[p];
                for_each_node(patch, store, grid.nodes_x(),
                              [&](std::size_t i, const NodeWeight& w) { own -= w.value * mean[i]; });
                particles.velocity_solid.set(p, own);
            });
    });
}

} // namespace quicksand
