// Cells that are badly filled, and the good cells that they lean on (aggregated finite elements: Badia,
// Verdugo and Martin 2018).
//
// Where an outline cuts cells, some hold a sliver. A node of such cells alone carries next to no mass and
// takes any velocity; the pressure of such a cell has no volume to act on. A badly filled cell therefore
// shares the pressure (and the mean change of volume) of its root, the nearest good cell, and a node without
// a good cell follows the velocities of a good cell, continued linearly.
#pragma once

#include "solver/boundary_conditions.hpp"
#include "solver/cell_lists.hpp"
#include "solver/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// A badly filled cell and the good one that it shares its pressure with; slots of the cell lists.
struct SharedCell {
    std::int32_t slot = 0, root = 0;

    bool operator==(const SharedCell&) const = default;
};

struct CellRoots {
    std::vector<std::uint8_t> good_nodes; // by node: 1 where a good cell lies beside it, 0 elsewhere
    std::vector<std::uint8_t> good_cells; // by cell of the grid
    Scalars fill;                         // of the cells: soil volume over the cell's [-]
    std::vector<SharedCell> shared;       // in the order of the slots
};

/// Whether outlines cut domains: soil then ends within cells.
bool has_cut_soil(const Problem& problem);

/// Tell good cells from others. Tied nodes share their cells with their masters.
void find_roots(const Problem& problem, const NodeConditions& conditions, const CellLists& lists,
                const Particles& particles, CellRoots& roots);

/// A part of v_k = sum weight_m v_m.
struct FollowedNode {
    std::size_t node = 0;
    double weight = 0.0; // [-]
};

/// What a node without a good cell follows: corners of the nearest good cell, or the mean of several that are
/// equally near and full. None: no good cell is near.
std::vector<FollowedNode> follow(const BackgroundGrid& grid, const CellRoots& roots, std::size_t node);

/// The lists with the particles of shared cells in the slots of their roots.
void merge_shared_cells(const CellLists& lists, const std::vector<SharedCell>& shared, CellLists& merged);

} // namespace quicksand
