// The slope of the water's pressure in a cell, from the means of the cells around it.
#pragma once

#include "solver/base/slope_fit.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/water/cell_means.hpp"

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

/// The root of the part with which a neighbour counts in the slope of a cell: the smaller conductivity of the
/// two over the larger. Pressures bend at faces between soils, and a slope across such a face, which the flow
/// in the soil of the larger one does not know, drives water in rolls there whose drag takes energy from
/// nowhere.
inline double root_of_part(const CellMeans& means, std::size_t slot, std::size_t other)
{
    return std::exp(-0.5 * std::abs(means.conductivity[slot] - means.conductivity[other]));
}

/// Of the pressure of the cells, pressure_of(slot) [Pa/m].
template <class PressureOf>
Vector2 pressure_slope(const Problem& problem, const CellLists& lists, const CellMeans& means,
                       std::size_t slot, PressureOf&& pressure_of)
{
    const std::int32_t cell = lists.cell_of_slot[slot], columns = problem.grid.all_cells_x();
    const Vector2 centre = means.centre[slot];
    const double pressure = pressure_of(slot);
    SlopeFit fit;
    const bool alike = means.of_material.empty();
    const auto add = [&](std::size_t other, const Vector2& apart) {
        const double change = pressure_of(other) - pressure;
        if (alike) return fit.add(apart, change);
        const double root = root_of_part(means, slot, other);
        fit.add(root * apart, root * change);
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
    return fit.slope(problem.grid.cell_size);
}

} // namespace quicksand
