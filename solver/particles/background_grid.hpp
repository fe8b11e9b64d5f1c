// The background grid: square cells, row by row, with a rim of ghost cells around the cells of the scene.
//
// Node (i, j) has index j * nodes_x + i; i and j count from the ghost rim's lower left corner. The rim takes
// the weight of particle corners that leave the scene's cells by a fraction of a cell.
#pragma once

#include "solver/base/conventions.hpp"

#include <cstddef>

namespace quicksand {

/// The cell that holds a point, counted from the rim's lower left corner, and the point's place in it.
struct PlaceInCell {
    int i = 0, j = 0;           // column and row of the cell, and of the node at its lower left [-]
    double xi = 0.0, eta = 0.0; // 0..1 from that node to the right and up [-]
};

/// The place of a point that lies `cells` from the rim's lower left corner [-]; no coordinate is negative.
inline PlaceInCell place_in_cell(const Vector2& cells)
{
    const int i = static_cast<int>(cells.x()), j = static_cast<int>(cells.y());
    return {i, j, cells.x() - i, cells.y() - j};
}

/// The same; where it is nearer to a grid line than `tolerance` [cells] the point lies on it.
inline PlaceInCell place_in_cell(const Vector2& cells, double tolerance)
{
    PlaceInCell place = place_in_cell(cells);
    for (double* part : {&place.xi, &place.eta}) {
        if (*part < tolerance) *part = 0.0;
        if (*part > 1.0 - tolerance) *part = 1.0;
    }
    return place;
}

struct BackgroundGrid {
    static constexpr int ghost_cells = 4;

    /// Farthest a particle's domain may reach from its centre along an axis [cells]. Tiles of cells that are
    /// scattered at the same time and the rim are wide enough for it.
    static constexpr double domain_reach = 2.5;

    /// `line_tolerance` of shapes that do not move, in small strain and in strength reduction: a corner that
    /// reaches over a line by less gives the nodes beyond it almost no soil. They would have to move by many
    /// cells before that soil bears them, and find no rest where it yields [cells].
    static constexpr double line_tolerance_of_still_shapes = 2e-3;

    Vector2 origin = Vector2::Zero(); // lower left corner of the scene's cells [m]
    double cell_size = 0.0;           // h [m]
    int cells_x = 0;                  // cells of the scene, without the rim [-]
    int cells_y = 0;
    double line_tolerance = 0.0; // corners of domains nearer to a grid line lie on it [cells]

    int all_cells_x() const { return cells_x + 2 * ghost_cells; }
    int all_cells_y() const { return cells_y + 2 * ghost_cells; }
    int nodes_x() const { return all_cells_x() + 1; }
    int nodes_y() const { return all_cells_y() + 1; }
    std::size_t cell_count() const
    {
        return static_cast<std::size_t>(all_cells_x()) * static_cast<std::size_t>(all_cells_y());
    }
    std::size_t node_count() const
    {
        return static_cast<std::size_t>(nodes_x()) * static_cast<std::size_t>(nodes_y());
    }

    /// Lower left corner of the rim [m].
    Vector2 rim_origin() const { return origin - Vector2::Constant(ghost_cells * cell_size); }
    Vector2 node_position(int i, int j) const { return rim_origin() + cell_size * Vector2(i, j); }
    Vector2 node_position(std::size_t node) const
    {
        const auto row = static_cast<std::size_t>(nodes_x());
        return node_position(static_cast<int>(node % row), static_cast<int>(node / row));
    }

    std::size_t node_index(int i, int j) const { return static_cast<std::size_t>(j * nodes_x() + i); }

    /// How far a point lies from the rim's lower left corner [cells].
    Vector2 cells_from_rim(const Vector2& point) const { return (point - rim_origin()) / cell_size; }

    /// Upper right corner of the scene's cells [m].
    Vector2 upper_corner() const { return origin + cell_size * Vector2(cells_x, cells_y); }
};

} // namespace quicksand
