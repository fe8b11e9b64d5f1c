#include "solver/cell_strain/shared_means.hpp"

#include "solver/cell_strain/cell_walk.hpp"

#include <algorithm>

namespace quicksand {

namespace {

constexpr double own_part = 0.1; // of what a value differs from the mean [-]

/// Whether water that stays in its pores parts a cell: some of its particles have none.
bool is_parted_by_kept_water(const Problem& problem, const SharedSoils& shared, CellEntries cell,
                             const Particles& particles)
{
    if (shared.water != SharedWater::kept) return false;
    const auto has_water = [&](std::int32_t k) {
        const auto material = static_cast<std::size_t>(particles.material[static_cast<std::size_t>(k)]);
        return is_wet(problem.materials[material]);
    };
    return std::any_of(cell.begin(), cell.end(),
                       [&](std::int32_t k) { return has_water(k) != has_water(cell.front()); });
}

bool has_mean(const Problem& problem, const CellLists& lists, std::size_t slot, const SharedSoils& shared,
              const Soils& soils)
{
    const CellEntries cell = entries_of(lists, slot);
    if (!is_shared(cell, soils)) return false;
    const std::int32_t main = main_soil(cell, soils), second = second_soil(cell, main, soils);
    if (main == second || is_parted_by_kept_water(problem, shared, cell, soils.particles)) return false;
    const Contrast contrast = shared.contrast(main, second);
    if (contrast == Contrast::none) return false;
    if (contrast == Contrast::unlike) return true;
    const WholeCells whole = whole_cells(parts_around(problem.grid, lists, slot, main, soils));
    const bool main_bears = contrast == Contrast::first_bears;
    return main_bears ? whole.of_main || !whole.of_others : whole.of_others || !whole.of_main;
}

} // namespace

void find_cells_with_means(const Problem& problem, const CellLists& lists, const SharedSoils& shared,
                           const Particles& particles, CellsWithMeans& cells)
{
    if (shared.of_material.empty()) return;
    const Soils soils{shared.of_material, shared.slivers, particles};
    cells.assign(lists.cell_of_slot.size(), 0);
    for_each_slot(lists, [&](std::size_t slot) {
        cells[slot] = has_mean(problem, lists, slot, shared, soils) ? 1 : 0;
    });
}

void approach_means(const CellLists& lists, const SharedSoils& shared, const CellsWithMeans& cells,
                    const Particles& particles, std::initializer_list<Scalars*> values)
{
    if (cells.empty()) return;
    const Soils soils{shared.of_material, shared.slivers, particles};
    const auto approach = [&](CellEntries cell, Scalars& value) {
        double volume = 0.0, sum = 0.0;
        for (const std::int32_t k : cell) {
            if (soils.is_sliver(k)) continue;
            const auto p = static_cast<std::size_t>(k);
            volume += particles.volume[p];
            sum += particles.volume[p] * value[p];
        }
        const double mean = sum / volume;
        for (const std::int32_t k : cell)
            if (!soils.is_sliver(k)) {
                double& own = value[static_cast<std::size_t>(k)];
                own = mean + own_part * (own - mean);
            }
    };
    for_each_slot(lists, [&](std::size_t slot) {
        if (cells[slot] == 0) return;
        for (Scalars* value : values) approach(entries_of(lists, slot), *value);
    });
}

} // namespace quicksand
