// Cells that are badly filled, and the good cells that they lean on (aggregated finite elements: Badia,
// Verdugo and Martin 2018).
//
// Where an outline cuts cells, some hold a sliver. A node of such cells alone carries next to no mass and
// takes any velocity; the pressure of such a cell has no volume to act on. A badly filled cell therefore
// shares the pressure (and the mean change of volume) of its root, the nearest good cell, and a node without
// a good cell follows the velocities of a good cell, continued linearly. Soil that is torn, as in a splash,
// follows the nearest corner instead: what flies away is not thrown by the spread of what it leaves.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// A badly filled cell and the good one that it shares its pressure with; slots of the cell lists.
struct SharedCell {
    std::int32_t slot = 0, root = 0;

    bool operator==(const SharedCell&) const = default;
};

enum class Filling : std::uint8_t {
    none,
    torn, // badly, with soil far looser than as sampled
    bad,
    good
};

struct CellRoots {
    Scalars fill;                   // of the cells with soil: its volume over the cell's [-]
    std::vector<Filling> filling;   // by cell of the grid
    std::vector<SharedCell> shared; // in the order of the slots
    std::vector<std::size_t>
        followers;               // nodes that soil may reach and no good cell lies beside, in their order
    std::vector<Filling> marked; // the filling for which the followers were found
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

/// What a node without a good cell follows: corners of the nearest good cell (one in torn soil), or the mean
/// of several that are equally near and full. None: no good cell is near.
void follow(const BackgroundGrid& grid, const CellRoots& roots, std::size_t node,
            std::vector<FollowedNode>& followed);

/// Lists with the particles of shared cells in the slots of their roots.
struct SharedLists {
    CellLists lists;
    std::vector<SharedCell> shared; // for which, and for which lists, they hold
    std::int64_t changes = -1;
};

/// Bring them up to date with the lists of the cells themselves.
void merge_shared_cells(const CellLists& lists, const std::vector<SharedCell>& shared, SharedLists& merged);

} // namespace quicksand
