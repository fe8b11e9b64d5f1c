#include "solver/nodal_fields.hpp"

#include "solver/cell_lists.hpp"
#include "solver/cpdi.hpp"
#include "solver/monitors.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Call visit(array) for every averaged array, in one fixed order.
template <class Visit>
void for_each_field(NodalFields& fields, std::optional<WaterFlow> flow, Visit&& visit)
{
    visit(fields.displacement.x);
    visit(fields.displacement.y);
    visit(fields.velocity_solid.x);
    visit(fields.velocity_solid.y);
    visit(fields.mean_effective_stress);
    visit(fields.vertical_effective_stress);
    visit(fields.shear_stress_xy);
    if (!flow) return;
    visit(fields.pore_pressure);
    visit(fields.excess_pore_pressure);
    visit(fields.ru);
    visit(fields.porosity);
    if (flow != WaterFlow::coupled) return;
    visit(fields.velocity_fluid.x);
    visit(fields.velocity_fluid.y);
}

constexpr std::size_t most_fields = 13;

/// The particle's values in the order of for_each_field.
void particle_values(const Problem& problem, const Particles& particles, std::size_t p, double* values)
{
    const SymmetricTensors& stress = particles.stress;
    *values++ = particles.position.x[p] - particles.reference_position.x[p];
    *values++ = particles.position.y[p] - particles.reference_position.y[p];
    *values++ = particles.velocity_solid.x[p];
    *values++ = particles.velocity_solid.y[p];
    *values++ = -(stress.xx[p] + stress.yy[p] + stress.zz[p]) / 3.0;
    *values++ = -stress.yy[p];
    *values++ = stress.xy[p];
    if (!particles.has_fluid()) return;
    const double excess = excess_pore_pressure(particles, p);
    const double initial = particles.initial_vertical_effective_stress[p];
    *values++ = static_water_pressure(problem, particles.position.y[p]) + excess;
    *values++ = excess;
    *values++ = excess / std::max(initial, ru_stress_threshold(problem));
    *values++ = particles.porosity[p];
    if (particles.velocity_fluid.x.empty()) return;
    *values++ = particles.velocity_fluid.x[p];
    *values++ = particles.velocity_fluid.y[p];
}

} // namespace

NodalFields nodal_fields(const Problem& problem, const Particles& particles)
{
    const BackgroundGrid& grid = problem.grid;
    NodalFields fields;
    fields.volume.assign(grid.node_count(), 0.0);
    std::vector<Scalars*> arrays;
    for_each_field(fields, carried_flow(particles), [&](Scalars& field) {
        field.assign(grid.node_count(), 0.0);
        arrays.push_back(&field);
    });

    NodePatch patch;
    double values[most_fields];
    for (std::size_t p = 0; p < particles.size(); ++p) {
        ParallelogramDomain domain{particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p]};
        limit_domain(grid.cell_size, domain);
        evaluate_cpdi(grid, domain, patch);
        particle_values(problem, particles, p, values);
        for (int k = 0; k < patch.width * patch.height; ++k) {
            const int node = patch.base + k / patch.width * grid.nodes_x() + k % patch.width;
            const double weight = patch.weights[k].value * particles.volume[p];
            fields.volume[static_cast<std::size_t>(node)] += weight;
            for (std::size_t f = 0; f < arrays.size(); ++f)
                (*arrays[f])[static_cast<std::size_t>(node)] += weight * values[f];
        }
    }
    for (std::size_t i = 0; i < grid.node_count(); ++i) {
        if (fields.volume[i] <= 0.0) continue;
        for (Scalars* array : arrays) (*array)[i] /= fields.volume[i];
    }
    return fields;
}

PointWeights point_weights(const BackgroundGrid& grid, const NodalFields& fields, const Vector2& point)
{
    PointWeights result;
    const Vector2 cells = (point - grid.rim_origin()) / grid.cell_size;
    const bool in_grid = cells.x() >= 0.0 && cells.y() >= 0.0 && cells.x() <= grid.all_cells_x() &&
                         cells.y() <= grid.all_cells_y();
    if (!in_grid) return result;
    const int i = std::min(static_cast<int>(cells.x()), grid.all_cells_x() - 1);
    const int j = std::min(static_cast<int>(cells.y()), grid.all_cells_y() - 1);
    const double xi = cells.x() - i, eta = cells.y() - j;
    result.inside = true;
    for (int k = 0; k < 4; ++k) {
        const int a = k % 2, b = k / 2;
        result.node[k] = static_cast<std::size_t>((j + b) * grid.nodes_x() + i + a);
        result.weight[k] = (a == 0 ? 1.0 - xi : xi) * (b == 0 ? 1.0 - eta : eta);
        result.inside = result.inside && fields.volume[result.node[k]] > 0.0;
    }
    return result;
}

} // namespace quicksand
