#include "solver/inertia/cell_moduli.hpp"

#include <algorithm>
#include <cmath>
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

/// Of a domain: 1 of a square, a/b + b/a - 1 of a rectangle with the sides a and b [-].
double elongation(const Vector2& half_edge_1, const Vector2& half_edge_2)
{
    const double area = std::abs(half_edge_1.x() * half_edge_2.y() - half_edge_1.y() * half_edge_2.x());
    return (half_edge_1.squaredNorm() + half_edge_2.squaredNorm()) / area - 1.0;
}

void add_to_cell(double fraction, const Moduli& moduli, double x, double y, double elongation,
                 StiffnessSums& cell)
{
    const double M = fraction * moduli.constrained, Mx = M * x, My = M * y;
    cell.constrained += M;
    cell.shear += fraction * moduli.shear;
    cell.x += Mx;
    cell.y += My;
    cell.xx += Mx * x;
    cell.xy += Mx * y;
    cell.yy += My * y;
    cell.filled += fraction;
    cell.elongation += M * elongation;
}

/// From the middle of a cell to that of what a domain has in it, along an axis.
double place_within(double from_rim, int cell)
{
    return std::clamp(from_rim - cell - 0.5, -0.5, 0.5);
}

/// Give the cells of a stencil their parts of a volume with the moduli; its middle lies `from_rim` [cells].
void add_volume(const StoredStencil& stencil, const double* phi, const Vector2& from_rim, double fraction,
                const Moduli& moduli, double elongation, const NodeRows& rows,
                std::vector<StiffnessSums>& cells)
{
    constexpr int most = NodeStencil::max_width;
    const int width = stencil.width, height = stencil.height;
    double parts[most * most], x[most];
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
    for (int a = 0; a + 1 < width; ++a) x[a] = place_within(from_rim.x(), stencil.column + a);
    StiffnessSums* row = cells.data() + rows.place(static_cast<std::size_t>(stencil.column),
                                                   static_cast<std::size_t>(stencil.row));
    for (int b = 0, k = 0; b + 1 < height; ++b, row += rows.stride) {
        const double y = place_within(from_rim.y(), stencil.row + b);
        for (int a = 0; a + 1 < width; ++a, ++k)
            if (parts[k] > 0.0) add_to_cell(scale * parts[k], moduli, x[a], y, elongation, row[a]);
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
              const NodeRows& rows, std::vector<StiffnessSums>& cells)
{
    const double per_cell = 1.0 / (problem.grid.cell_size * problem.grid.cell_size);
    const Vectors& position = place_in_equations(problem, particles);
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
                add_volume(stencil, store.value.data() + stencil.first,
                           problem.grid.cells_from_rim(position[q]), per_cell * particles.volume[q], moduli,
                           elongation(particles.half_edge_1[q], particles.half_edge_2[q]), rows, cells);
            }
        }
    }
}

double square(double x)
{
    return x * x;
}

} // namespace

double eccentricity_factor(const StiffnessSums& cell)
{
    const double M = cell.constrained, c = 12.0 / (M + cell.shear), t = (cell.xx + cell.yy) / M;
    const double s = 0.5 * (t + std::sqrt(square(cell.xx - cell.yy) + 4.0 * square(cell.xy)) / M);
    const double q = c * ((M - cell.shear) * s + cell.shear * t);
    const double r2 = (square(cell.x) + square(cell.y)) / (M * M);
    return std::max(1.0, 0.5 * (1.0 + q + std::sqrt(square(1.0 - q) + 4.0 * c * M * r2)));
}

double elongation_factor(const StiffnessSums& cell)
{
    const double alone = std::clamp(1.5 - 2.0 * cell.filled, 0.0, 1.0);
    return 1.0 + alone * (cell.elongation / cell.constrained - 1.0);
}

void sum_cell_moduli(const Problem& problem, double dt, const Particles& particles, const CellLists& lists,
                     const std::vector<StencilStore>& stencils, const std::vector<std::uint8_t>& resists,
                     const NodeRows& rows, CellModuli& cells)
{
    cells.sums.assign(rows.size(), {});
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        add_tile(problem, dt, particles, lists, tile, stencils[static_cast<std::size_t>(tile.number)],
                 resists, rows, cells.sums);
    });
    cells.constrained.resize(rows.size());
    cells.shear.resize(rows.size());
    for_each_index(rows.size(), [&](std::size_t k) {
        const StiffnessSums& sums = cells.sums[k];
        const double factor =
            sums.constrained > 0.0 ? eccentricity_factor(sums) * elongation_factor(sums) : 0.0;
        cells.constrained[k] = factor * sums.constrained;
        cells.shear[k] = factor * sums.shear;
    });
}

} // namespace quicksand
