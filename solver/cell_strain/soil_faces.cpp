#include "solver/cell_strain/soil_faces.hpp"

#include "solver/base/slope_fit.hpp"

#include <cmath>
#include <cstddef>

namespace quicksand {

namespace {

double part_of(std::int32_t soil, CellEntries cell, const Soils& soils)
{
    double part = 0.0, all = 0.0; // [m3/m]
    for (const std::int32_t p : cell) {
        if (soils[p] < 0) continue;
        const double volume = soils.particles.volume[static_cast<std::size_t>(p)];
        all += volume;
        if (soils[p] == soil) part += volume;
    }
    return all > 0.0 ? part / all : -1.0;
}

/// The soil with the largest volume of the particles that count, of equal ones the first by number; `none`
/// where no particle does.
template <class Counts>
std::int32_t largest_soil(CellEntries cell, const Soils& soils, std::int32_t none, Counts&& counts)
{
    std::int32_t soil = none;
    double largest = 0.0; // [m3/m]
    for (const std::int32_t first : cell) {
        if (!counts(first)) continue;
        double volume = 0.0;
        for (const std::int32_t p : cell)
            if (soils[p] == soils[first] && counts(p))
                volume += soils.particles.volume[static_cast<std::size_t>(p)];
        if (volume > largest || (volume == largest && soils[first] < soil))
            largest = volume, soil = soils[first];
    }
    return soil;
}

} // namespace

bool is_shared(CellEntries cell, const Soils& soils)
{
    bool shared = false;
    for (const std::int32_t p : cell) {
        const std::int32_t soil = soils[p];
        if (soil < 0) return false;
        shared = shared || soil != soils[cell.front()];
    }
    return shared;
}

std::int32_t main_soil(CellEntries cell, const Soils& soils)
{
    return largest_soil(cell, soils, 0, [](std::int32_t) { return true; });
}

std::int32_t second_soil(CellEntries cell, std::int32_t main, const Soils& soils)
{
    return largest_soil(cell, soils, main,
                        [&](std::int32_t p) { return soils[p] != main && !soils.is_sliver(p); });
}

PartsAround parts_around(const BackgroundGrid& grid, const CellLists& lists, std::size_t slot,
                         std::int32_t main, const Soils& soils)
{
    const int columns = grid.all_cells_x(), rows = grid.all_cells_y();
    const int cell = lists.cell_of_slot[slot], i = cell % columns, j = cell / columns;
    PartsAround parts;
    for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) {
            double& part = parts[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
            part = -1.0;
            const int column = i + a - 1, row = j + b - 1;
            if (column < 0 || column >= columns || row < 0 || row >= rows) continue;
            const auto neighbour = static_cast<std::size_t>(row * columns + column);
            const auto of_it = static_cast<std::size_t>(lists.slot_of_cell[neighbour]);
            part = part_of(main, entries_of(lists, of_it), soils);
        }
    }
    return parts;
}

Vector2 normal_of_face(const PartsAround& parts, const Vector2& apart, double cell_size)
{
    constexpr double least_slope = 0.05, least_distance = 0.1; // of a part over a cell [-]; [cells]
    const double here = parts[1][1];
    double xx = 0.0, xy = 0.0, yy = 0.0; // sum of g g^T
    for (const std::size_t b : {0U, 2U}) {
        for (const std::size_t a : {0U, 2U}) {
            const double beside = parts[1][a], above = parts[b][1], across = parts[b][a];
            const double x = static_cast<double>(a) - 1.0, y = static_cast<double>(b) - 1.0; // [cells]
            if (beside < 0.0 && above < 0.0) continue; // a diagonal alone tells no direction
            SlopeFit fit;
            if (beside >= 0.0) fit.add({x, 0.0}, beside - here);
            if (above >= 0.0) fit.add({0.0, y}, above - here);
            if (across >= 0.0) fit.add({x, y}, across - here);
            const Vector2 g = fit.slope(1.0);
            xx += g.x() * g.x();
            xy += g.x() * g.y();
            yy += g.y() * g.y();
        }
    }
    const double difference = xx - yy, between = std::hypot(difference, 2.0 * xy); // of the eigenvalues
    if (!(between > least_slope * least_slope)) {
        const double distance = apart.norm();
        return distance > least_distance * cell_size ? Vector2(apart / distance) : Vector2::Zero();
    }
    const double cosine = difference / between; // of twice the angle between the eigenvector and x
    return {std::sqrt(0.5 * (1.0 + cosine)), std::copysign(std::sqrt(0.5 * (1.0 - cosine)), xy)};
}

WholeCells whole_cells(const PartsAround& parts)
{
    constexpr double rest = 1e-6; // of a cell's soil
    WholeCells whole;
    for (const auto& row : parts) {
        for (const double part : row) {
            whole.of_main = whole.of_main || part > 1.0 - rest;
            whole.of_others = whole.of_others || (part >= 0.0 && part < rest);
        }
    }
    return whole;
}

} // namespace quicksand
