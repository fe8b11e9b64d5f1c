#include "solver/step/free_field_rows.hpp"

#include "solver/base/failure.hpp"

#include <cmath>

namespace quicksand {

SectionStress section_stress(const Problem& column, const Particles& particles)
{
    SectionStress stress;
    const std::size_t count = particles.size();
    for (Scalars* values :
         {&stress.traction.x, &stress.traction.y, &stress.pressure, &stress.volume, &stress.water_volume})
        values->assign(count, 0.0);
    for (std::size_t p = 0; p < count; ++p) {
        const auto number = static_cast<std::size_t>(particles.identifier[p]);
        const double V = particles.volume[p];
        stress.traction.set(number, {V * particles.stress.xx[p], V * particles.stress.xy[p]});
        if (!particles.pore_pressure.empty()) stress.pressure[number] = V * particles.pore_pressure[p];
        stress.volume[number] = V;
        const Material& material = column.materials[static_cast<std::size_t>(particles.material[p])];
        if (water_of(column, material)) stress.water_volume[number] = V;
    }
    return stress;
}

void find_section_forces(const Problem& column, const StepWorkspace& work, const Particles& particles,
                         const SectionStress& stress, const std::function<double(std::size_t)>& more_pressure,
                         FreeFieldRows& rows)
{
    const auto count = static_cast<std::size_t>(column.grid.nodes_y());
    const std::int32_t nodes_x = column.grid.nodes_x();
    const double h = column.grid.cell_size;
    rows.force.x.assign(count, 0.0);
    rows.force.y.assign(count, 0.0);
    rows.pressure.assign(count, 0.0);
    rows.height.assign(count, 0.0);
    for (const Tile& tile : work.lists.tiles) {
        const StencilStore& store = work.stencils_of(tile);
        const StoredStencil* stencil = store.stencils.data();
        for (std::size_t k = work.lists.first_entry(tile); k < work.lists.last_entry(tile); ++k, ++stencil) {
            const auto p = static_cast<std::size_t>(work.lists.order[k]);
            const auto number = static_cast<std::size_t>(particles.identifier[p]);
            const double water = stress.water_volume[number];
            const Vector2 traction = stress.traction[number] / h;
            double pressure = stress.pressure[number] / h;
            if (water > 0.0) pressure += water / h * more_pressure(p);
            const double height = stress.volume[number] / h;
            for_each_node(*stencil, store, nodes_x, [&](std::size_t node, const NodeWeight& weight) {
                const std::size_t row = node / static_cast<std::size_t>(nodes_x);
                rows.force.x[row] += weight.value * traction.x();
                rows.force.y[row] += weight.value * traction.y();
                rows.pressure[row] += weight.value * pressure;
                rows.height[row] += weight.value * height;
            });
        }
    }
}

void find_row_velocities(const Problem& column, const Stepper& stepper, FreeFieldRows& rows)
{
    const int count = column.grid.nodes_y();
    const int side = static_cast<int>(
        std::lround((column.tied_sides->x_left - column.grid.rim_origin().x()) / column.grid.cell_size));
    rows.velocity.x.assign(static_cast<std::size_t>(count), 0.0);
    rows.velocity.y.assign(static_cast<std::size_t>(count), 0.0);
    // nodes that soil reaches by a corner have hardly any mass and any velocity
    const double least_height = 0.1 * column.grid.cell_size;
    int first = -1, last = -1; // rows with soil
    for (int j = 0; j < count; ++j) {
        const bool filled = rows.height[static_cast<std::size_t>(j)] >= least_height;
        const auto velocity = filled ? stepper.mean_velocity(column.grid.node_index(side, j)) : std::nullopt;
        if (velocity) {
            if (first < 0) first = j;
            last = j;
        }
        if (last >= 0)
            rows.velocity.set(static_cast<std::size_t>(j),
                              velocity ? *velocity : rows.velocity[static_cast<std::size_t>(last)]);
    }
    ENSURE(first >= 0);
    for (int j = 0; j < first; ++j)
        rows.velocity.set(static_cast<std::size_t>(j), rows.velocity[static_cast<std::size_t>(first)]);
}

} // namespace quicksand
