#include "solver/particle_to_grid.hpp"

#include "solver/cpdi.hpp"
#include "solver/cpdi2.hpp"
#include "solver/failure.hpp"
#include "solver/gimp.hpp"
#include "solver/linear_interpolation.hpp"

namespace quicksand {

namespace {

/// Call add(node, phi, grad_x, grad_y, dx, dy) for every node of a patch; dx, dy = x_i - x_p.
template <class Add>
void for_each_node(const StoredPatch& patch, const NodeWeight* weights, std::int32_t nodes_x,
                   double cell_size, Add&& add)
{
    for (std::int32_t b = 0; b < patch.height; ++b) {
        const double dy = patch.offset_y + b * cell_size;
        const auto row = static_cast<std::size_t>(patch.base + b * nodes_x);
        for (std::int32_t a = 0; a < patch.width; ++a, ++weights) {
            add(row + static_cast<std::size_t>(a), *weights, patch.offset_x + a * cell_size, dy);
        }
    }
}

template <NodeInterpolation Member>
std::int64_t evaluate_tile(const BackgroundGrid& grid, const Particles& particles, const CellLists& lists,
                           const Tile& tile, PatchStore& store)
{
    store.clear();
    std::int64_t limited = 0;
    NodePatch patch;
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k) {
        limited += Member::evaluate(grid, particles, static_cast<std::size_t>(lists.order[k]), patch);
        store.push_back(patch);
    }
    return limited;
}

} // namespace

void compute_carried_masses(const Problem& problem, const Particles& particles, CarriedMasses& masses)
{
    masses.inertia = particles.mass_solid;
    masses.weight = particles.mass_solid;
    if (!problem.water) return;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        masses.inertia[p] += problem.water->density * particles.porosity[p] * particles.volume[p];
        masses.weight[p] = masses.inertia[p] - problem.water->density * particles.volume[p];
    }
}

std::int64_t evaluate_weights(const Problem& problem, const Particles& particles, const CellLists& lists,
                              const Tile& tile, PatchStore& store)
{
    const BackgroundGrid& grid = problem.grid;
    switch (problem.interpolation) {
    case Interpolation::linear:
        return evaluate_tile<LinearInterpolation>(grid, particles, lists, tile, store);
    case Interpolation::gimp:
        return evaluate_tile<UniformGimp>(grid, particles, lists, tile, store);
    case Interpolation::cpgimp:
        return evaluate_tile<ContiguousGimp>(grid, particles, lists, tile, store);
    case Interpolation::cpdi:
        return evaluate_tile<Cpdi>(grid, particles, lists, tile, store);
    case Interpolation::cpdi2:
        return evaluate_tile<Cpdi2>(grid, particles, lists, tile, store);
    }
    ENSURE(false);
}

void scatter_two_phase(const Problem& problem, const Particles& particles, const CellLists& lists,
                       const Tile& tile, const PatchStore& store, std::vector<TwoPhaseSums>& sums)
{
    const Water& water = *problem.water;
    const Gradients &Ls = particles.velocity_gradient_solid, &Lw = particles.velocity_gradient_fluid;
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        const double V = particles.volume[p], n = particles.porosity[p];
        const double m_s = particles.mass_solid[p], m_w = n * water.density * V;
        const double C = V * drag_coefficient(material, water, n);
        const double sxx = V * particles.stress.xx[p], syy = V * particles.stress.yy[p],
                     sxy = V * particles.stress.xy[p];
        const double pressure = V * particles.pore_pressure[p];
        const Vector2 v_s = particles.velocity_solid[p], v_w = particles.velocity_fluid[p];

        for_each_node(*patch, store.weights.data() + patch->first, problem.grid.nodes_x(),
                      problem.grid.cell_size, [&](std::size_t i, const NodeWeight& w, double dx, double dy) {
                          TwoPhaseSums& node = sums[i];
                          node.mass_solid += w.value * m_s;
                          node.mass_fluid += w.value * m_w;
                          node.volume += w.value * V;
                          node.drag += w.value * C;
                          node.momentum_solid_x += w.value * m_s * (v_s.x() + Ls.xx[p] * dx + Ls.xy[p] * dy);
                          node.momentum_solid_y += w.value * m_s * (v_s.y() + Ls.yx[p] * dx + Ls.yy[p] * dy);
                          node.momentum_fluid_x += w.value * m_w * (v_w.x() + Lw.xx[p] * dx + Lw.xy[p] * dy);
                          node.momentum_fluid_y += w.value * m_w * (v_w.y() + Lw.yx[p] * dx + Lw.yy[p] * dy);
                          node.stress_force_x -= sxx * w.gradient_x + sxy * w.gradient_y;
                          node.stress_force_y -= sxy * w.gradient_x + syy * w.gradient_y;
                          node.pressure_force_x += pressure * w.gradient_x;
                          node.pressure_force_y += pressure * w.gradient_y;
                      });
    }
}

void scatter_single_phase(const BackgroundGrid& grid, const Particles& particles, const CarriedMasses& masses,
                          const CellLists& lists, const Tile& tile, const PatchStore& store,
                          std::vector<SinglePhaseSums>& sums)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const double V = particles.volume[p], m = masses.inertia[p], weight = masses.weight[p];
        const double sxx = V * particles.stress.xx[p], syy = V * particles.stress.yy[p],
                     sxy = V * particles.stress.xy[p];
        const Vector2 v = particles.velocity_solid[p];

        for_each_node(*patch, store.weights.data() + patch->first, grid.nodes_x(), grid.cell_size,
                      [&](std::size_t i, const NodeWeight& w, double dx, double dy) {
                          SinglePhaseSums& node = sums[i];
                          node.mass += w.value * m;
                          node.weight += w.value * weight;
                          node.momentum_x += w.value * m * (v.x() + L.xx[p] * dx + L.xy[p] * dy);
                          node.momentum_y += w.value * m * (v.y() + L.yx[p] * dx + L.yy[p] * dy);
                          node.stress_force_x -= sxx * w.gradient_x + sxy * w.gradient_y;
                          node.stress_force_y -= sxy * w.gradient_x + syy * w.gradient_y;
                      });
    }
}

void scatter_body_force(const Problem& problem, double time, const Particles& particles,
                        const CarriedMasses& masses, const CellLists& lists, const Tile& tile,
                        const PatchStore& store, std::vector<SinglePhaseSums>& sums)
{
    const StoredPatch* patch = store.patches.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++patch) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const Vector2 force =
            masses.inertia[p] * problem.body_acceleration(particles.reference_position[p], time);
        for_each_node(*patch, store.weights.data() + patch->first, problem.grid.nodes_x(),
                      problem.grid.cell_size, [&](std::size_t i, const NodeWeight& w, double, double) {
                          sums[i].stress_force_x += w.value * force.x();
                          sums[i].stress_force_y += w.value * force.y();
                      });
    }
}

} // namespace quicksand
