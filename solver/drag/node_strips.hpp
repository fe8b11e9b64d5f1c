// What a node knows of the soil in the strips of its support along the axes of the grid.
#pragma once

#include <cstddef>

namespace quicksand {

/// Volumes and resistances of the strips about a node, from below to above and from left to right.
struct alignas(64) NodeStrips {
    static constexpr std::size_t per_cell = 8, count = 2 * per_cell;

    double row_volume[count], column_volume[count];         // W_s [m3/m]
    double row_resistance[count], column_resistance[count]; // R_s [N s/m2]
    double conductance;                                     // sum W^2 / R of the particles [m4/(N s)]
};

} // namespace quicksand
