// The pressure of the water in a small motion: one for each cell.
#pragma once

#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

namespace quicksand {

/// Give the particles of the lists the pressure K_w sum V div q / sum n V of their cell in a unit of time,
/// with divergence(p) = div q of the flux [1/s]: the force sum V p grad phi is then K v.
template <class Divergence>
void set_restoring_pressure(const Problem& problem, const CellLists& lists, Divergence&& divergence,
                            Particles& particles)
{
    for_each_tile(lists, [&](const Tile& tile) {
        for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
            const auto slot = static_cast<std::size_t>(c);
            const auto first = static_cast<std::size_t>(lists.cell_start[slot]);
            const auto last = static_cast<std::size_t>(lists.cell_start[slot + 1]);
            double pores = 0.0, outflow = 0.0; // [m3/m], [m3/s per metre]
            for (std::size_t k = first; k < last; ++k) {
                const auto p = static_cast<std::size_t>(lists.order[k]);
                pores += particles.volume[p] * particles.porosity[p];
                outflow += particles.volume[p] * divergence(p);
            }
            for (std::size_t k = first; k < last; ++k)
                particles.pore_pressure[static_cast<std::size_t>(lists.order[k])] =
                    problem.water->bulk_modulus * outflow / pores;
        }
    });
}

} // namespace quicksand
