#include "solver/inertia/cell_moduli.hpp"

#include <cstddef>
#include <cstdint>

namespace quicksand {

namespace {

/// P-wave and shear modulus of a run of particles with one material [Pa].
struct Moduli {
    double constrained, shear;
};

Moduli mean_moduli(const Material& material, double dt, const Particles& particles, std::size_t first,
                   std::size_t last)
{
    return std::visit(
        [&](const auto& law) {
            const double M = expected_moduli(law, dt, first, last, particles).mean;
            return Moduli{M, M * shear_modulus(law) / constrained_modulus(law)};
        },
        material.law);
}

/// Give the cells of a stencil their parts of a volume with the moduli.
void add_volume(const StoredStencil& stencil, const double* phi, double fraction, const Moduli& moduli,
                const NodeRows& rows, CellModuli& cells)
{
    const std::size_t corner =
        rows.place(static_cast<std::size_t>(stencil.column), static_cast<std::size_t>(stencil.row));
    const int width = stencil.width, height = stencil.height;
    double parts[NodeStencil::max_width * NodeStencil::max_width];
    double sum = 0.0;
    for (int b = 0, k = 0; b + 1 < height; ++b) {
        for (int a = 0; a + 1 < width; ++a, ++k) {
            const double* low = phi + b * width + a;
            parts[k] = low[0] * low[width + 1] + low[1] * low[width];
            sum += parts[k];
        }
    }
    if (!(sum > 0.0)) return; // a point on a grid line: its neighbours count
    const double scale = fraction / sum;
    for (int b = 0, k = 0; b + 1 < height; ++b) {
        const std::size_t row = corner + static_cast<std::size_t>(b) * rows.stride;
        for (int a = 0; a + 1 < width; ++a, ++k) {
            const std::size_t place = row + static_cast<std::size_t>(a);
            cells.constrained[place] += scale * parts[k] * moduli.constrained;
            cells.shear[place] += scale * parts[k] * moduli.shear;
        }
    }
}

/// The end of the entries from `first` on whose particles follow each other in memory and have one material.
std::size_t end_of_run(const Particles& particles, const CellLists& lists, std::size_t first,
                       std::size_t last)
{
    const auto p = static_cast<std::size_t>(lists.order[first]);
    std::size_t k = first + 1;
    while (k < last && static_cast<std::size_t>(lists.order[k]) == p + (k - first) &&
           particles.material[p + (k - first)] == particles.material[p])
        ++k;
    return k;
}

void add_tile(const Problem& problem, double dt, const Particles& particles, const CellLists& lists,
              const Tile& tile, const StencilStore& store, const std::vector<std::uint8_t>& resists,
              const NodeRows& rows, CellModuli& cells)
{
    const double per_cell = 1.0 / (problem.grid.cell_size * problem.grid.cell_size);
    const std::size_t first_entry = lists.first_entry(tile);
    for (std::int32_t slot = tile.first_cell; slot < tile.last_cell; ++slot) {
        const auto last = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(slot) + 1]);
        for (auto k = static_cast<std::size_t>(lists.cell_start[static_cast<std::size_t>(slot)]); k < last;) {
            const std::size_t end = end_of_run(particles, lists, k, last);
            const auto p = static_cast<std::size_t>(lists.order[k]);
            const auto m = static_cast<std::size_t>(particles.material[p]);
            if (resists[m] == 0) {
                k = end;
                continue;
            }
            const Material& material = problem.materials[m];
            const Moduli moduli = mean_moduli(material, dt, particles, p, p + (end - k));
            for (std::size_t q = p; k < end; ++k, ++q) {
                const StoredStencil& stencil = store.stencils[k - first_entry];
                add_volume(stencil, store.value.data() + stencil.first, per_cell * particles.volume[q],
                           moduli, rows, cells);
            }
        }
    }
}

} // namespace

void sum_cell_moduli(const Problem& problem, double dt, const Particles& particles, const CellLists& lists,
                     const std::vector<StencilStore>& stencils, const std::vector<std::uint8_t>& resists,
                     const NodeRows& rows, CellModuli& cells)
{
    cells.constrained.assign(rows.size(), 0.0);
    cells.shear.assign(rows.size(), 0.0);
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        add_tile(problem, dt, particles, lists, tile, stencils[static_cast<std::size_t>(tile.number)],
                 resists, rows, cells);
    });
}

} // namespace quicksand
