#include "solver/pore_pressure.hpp"

namespace quicksand {

void update_pore_pressure(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                          const Scalars& flux_divergence, Particles& particles)
{
    const Water& water = *problem.water;
    const double weight_density = water.density * problem.gravity; // gamma_w [N/m3]
    for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
        const auto first = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(c)]);
        const auto last = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(c) + 1]);
        double outflow = 0.0, pore_volume = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            outflow += particles.volume[p] * flux_divergence[p];
            pore_volume += particles.volume[p] * particles.porosity[p];
        }
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            particles.pore_pressure[p] += dt * (weight_density * particles.velocity_solid.y[p] -
                                                water.bulk_modulus * outflow / pore_volume);
        }
    }
}

} // namespace quicksand
