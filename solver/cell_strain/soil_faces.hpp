// The face between two soils that share a cell, from the cell and the eight around it.
#pragma once

#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quicksand {

/// The soil of every material, by the first one of its kind; below zero of solids. Empty where no two soils
/// can share a cell.
using SoilOfMaterial = std::vector<std::int32_t>;

/// The soils of particles.
struct Soils {
    const SoilOfMaterial& of_material;
    const std::vector<std::uint8_t>& slivers; // by lasting number
    const Particles& particles;
    std::int32_t operator[](std::int32_t p) const
    {
        return of_material[static_cast<std::size_t>(particles.material[static_cast<std::size_t>(p)])];
    }
    bool is_sliver(std::int32_t p) const
    {
        const auto number = static_cast<std::size_t>(particles.identifier[static_cast<std::size_t>(p)]);
        return number < slivers.size() && slivers[number] != 0;
    }
};

using CellEntries = std::span<const std::int32_t>; // particles of a cell

inline CellEntries entries_of(const CellLists& lists, std::size_t slot)
{
    const auto first = static_cast<std::size_t>(lists.cell_start[slot]);
    return CellEntries(lists.order)
        .subspan(first, static_cast<std::size_t>(lists.cell_start[slot + 1]) - first);
}

/// Whether a cell has several soils, and no solid.
bool is_shared(CellEntries cell, const Soils& soils);

/// The soil with the largest volume in the cell.
std::int32_t main_soil(CellEntries cell, const Soils& soils);

/// The other soil with the largest volume, slivers left out; the main one where all others are slivers.
std::int32_t second_soil(CellEntries cell, std::int32_t main, const Soils& soils);

/// A cell and those around it, by row and column: the part of their soil that is the main soil of the one in
/// the middle, solids left out; below zero without soil [-].
using PartsAround = std::array<std::array<double, 3>, 3>;

PartsAround parts_around(const BackgroundGrid& grid, const CellLists& lists, std::size_t slot,
                         std::int32_t main, const Soils& soils);

/// Normal of the face between the main soil and the others: the eigenvector of the sum of g g^T over the four
/// quarters of the surroundings, g the slope of the main soil's part there. It is also that of a thin layer
/// within one row of cells, on both sides of which the part is the same. Where the part is the same all
/// around, the direction `apart` from the centre of one to that of the other; zero if they have the same [-].
Vector2 normal_of_face(const PartsAround& parts, const Vector2& apart, double cell_size);

/// Whether a cell of the surroundings has none but the main soil, or none of it.
struct WholeCells {
    bool of_main = false, of_others = false;
};
WholeCells whole_cells(const PartsAround& parts);

} // namespace quicksand
