// The slope of the water's pressure in a cell, from the means of the cells around it.
#pragma once

#include "solver/base/slope_fit.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/water/cell_means.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace quicksand {

/// The soil of a cell beside another one, with the place where it is seen from there.
struct Neighbour {
    std::size_t slot = 0;
    double shift = 0.0; // of its centre along x [m]
};

/// The image of an empty cell on the other side of a laminar box; none: no soil there either.
inline std::optional<Neighbour> find_image(const Problem& problem, const CellLists& lists,
                                           const CellMeans& means, std::int32_t cell)
{
    const auto slot_of = [&](std::int32_t c) {
        return static_cast<std::size_t>(lists.slot_of_cell[static_cast<std::size_t>(c)]);
    };
    const double width = problem.tied_sides->x_right - problem.tied_sides->x_left;
    const auto cells = static_cast<std::int32_t>(std::lround(width / problem.grid.cell_size));
    const std::int32_t columns = problem.grid.all_cells_x(), column = cell % columns;
    if (column + cells < columns && means.volume[slot_of(cell + cells)] > 0.0)
        return Neighbour{slot_of(cell + cells), -width};
    if (column - cells >= 0 && means.volume[slot_of(cell - cells)] > 0.0)
        return Neighbour{slot_of(cell - cells), width};
    return std::nullopt;
}

/// The part with which a neighbour counts in the slope of a cell: the smaller conductivity of its soils over
/// the larger of the cell's. Pressures bend at faces between soils, and a slope across such a face, which the
/// flow in the more conductive soil does not know, drives water in rolls there whose drag takes energy from
/// nowhere. Less conductive soil may look across.
inline double part_of_neighbour(const CellMeans& means, std::size_t slot, std::size_t other)
{
    if (means.of_material.empty()) return 1.0;
    return std::exp(std::min(0.0, means.least_conductive[other] - means.most_conductive[slot]));
}

/// The part of the slope of a cell that is used, where the most conductive soil around has ln k `around`: its
/// water shares nodes with the cell, and forces of unlike slopes drive it without its pressure knowing. Up to
/// 1 : 1000 that takes less than 1e-3 of the energy.
inline double part_of_slope(const CellMeans& means, std::size_t slot, double around)
{
    constexpr double known = 6.9; // ln 1000
    return std::exp(std::min(0.0, known + means.least_conductive[slot] - around));
}

/// Of the pressure of the cells, pressure_of(slot) [Pa/m].
template <class PressureOf>
Vector2 pressure_slope(const Problem& problem, const CellLists& lists, const CellMeans& means,
                       std::size_t slot, PressureOf&& pressure_of)
{
    const std::int32_t cell = lists.cell_of_slot[slot], columns = problem.grid.all_cells_x();
    const Vector2 centre = means.centre[slot];
    const double pressure = pressure_of(slot);
    const bool alike = means.of_material.empty();
    double most_conductive = alike ? 0.0 : means.most_conductive[slot];
    PlaneFit fit;
    const auto add = [&](std::size_t other, const Vector2& apart) {
        if (!alike) most_conductive = std::max(most_conductive, means.most_conductive[other]);
        fit.add(weight_of_soil(means.volume[other], means.volume[slot]) *
                    part_of_neighbour(means, slot, other),
                apart, pressure_of(other) - pressure);
    };
    for (std::int32_t b = -1; b <= 1; ++b) {
        for (std::int32_t a = -1; a <= 1; ++a) {
            // centres never lie in the outermost cells of the rim, so that the neighbours exist
            const std::int32_t beside = cell + b * columns + a;
            const auto other = static_cast<std::size_t>(lists.slot_of_cell[static_cast<std::size_t>(beside)]);
            if (other == slot) continue;
            if (means.volume[other] > 0.0) {
                add(other, means.centre[other] - centre);
                continue;
            }
            const auto image =
                problem.tied_sides ? find_image(problem, lists, means, beside) : std::optional<Neighbour>();
            if (image) add(image->slot, means.centre[image->slot] + Vector2(image->shift, 0.0) - centre);
        }
    }
    const Vector2 slope = fit.slope(problem.grid.cell_size);
    return alike ? slope : Vector2(part_of_slope(means, slot, most_conductive) * slope);
}

} // namespace quicksand
