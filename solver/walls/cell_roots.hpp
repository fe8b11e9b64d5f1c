// Badly filled cells and their roots, the good cells with which they are aggregated (aggregated finite
// elements: Badia, Verdugo and Martin 2018).
//
// Where an outline cuts cells, some contain only a sliver of soil. A node of such cells alone has almost no
// mass, so that its velocity is arbitrary; the pressure of such a cell has almost no volume to act on. A
// badly filled cell is therefore aggregated with its root, the nearest good cell: both have one pressure and
// one mean change of volume. A node without a good cell follows the velocities of a good cell, extrapolated
// linearly. In torn soil, as in a splash, it follows the nearest corner instead, since extrapolated gradients
// would accelerate loose particles.
//
// Soil that shares a cell with a solid is badly filled for its water, too: the cell hardly changes its
// volume, for both have one strain and the solid is stiff, so that a pressure of its own would not follow
// that beside it.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace quicksand {

/// A badly filled cell and its root, which has the same pressure; slots of the cell lists.
struct AggregatedCell {
    std::int32_t slot = 0, root = 0;

    bool operator==(const AggregatedCell&) const = default;
};

enum class Filling : std::uint8_t {
    none,
    torn, // badly, with soil far looser than as sampled
    bad,
    good
};

struct CellRoots {
    Scalars fill;                           // of the cells with soil: its volume over the cell's [-]
    std::vector<Filling> filling;           // by cell of the grid
    std::vector<AggregatedCell> aggregated; // in the order of the slots
    std::vector<std::size_t>
        followers;               // nodes that soil may reach and no good cell lies beside, in their order
    std::vector<Filling> marked; // the filling for which the followers were found
};

/// Whether outlines cut domains: soil then ends within cells.
bool has_cut_soil(const Problem& problem);

/// Find the good cells and the roots of the others. The cells of a tied node are those of its master, too.
/// `spoilt` are the slots whose cells are bad however full, none or one number for each slot.
void find_roots(const Problem& problem, const NodeConditions& conditions, const CellLists& lists,
                const Particles& particles, const std::vector<std::uint8_t>& spoilt, CellRoots& roots);

/// The slots with particles of solids; none where the problem has no solids.
std::vector<std::uint8_t> slots_with_solids(const Problem& problem, const CellLists& lists,
                                            const Particles& particles);

/// A part of v_k = sum weight_m v_m.
struct FollowedNode {
    std::size_t node = 0;
    double weight = 0.0; // [-]
};

/// What a node without a good cell follows: corners of the nearest good cell (one in torn soil), or the mean
/// of several that are equally near and full. None: no good cell is near.
void follow(const BackgroundGrid& grid, const CellRoots& roots, std::size_t node,
            std::vector<FollowedNode>& followed);

/// Lists with the particles of aggregated cells in the slots of their roots.
struct AggregatedLists {
    CellLists lists;
    std::vector<AggregatedCell> aggregated; // from which the lists were made
    std::optional<std::int64_t> changes;    // of the cell lists from which they were made; none: not yet
};

/// Bring them up to date with the lists of the cells themselves.
void aggregate_cells(const CellLists& lists, const std::vector<AggregatedCell>& aggregated,
                     AggregatedLists& merged);

} // namespace quicksand
