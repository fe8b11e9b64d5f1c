// Nodes that soil shares with solids: grains and water move together there, so that no water enters a solid.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Set the conditions of the nodes from `drawn`, those of the curves, and the seals of solids: at the corners
/// of the cells that hold one, above the water only where no dry soil is into which it could rise. Such cells
/// have the pressure of others (cell_roots.hpp) and may take no water from them. So are nodes that no other
/// water reaches: a solid reaches over the corners of its cells as soon as it moves, and nothing else would
/// brake its water there. Where a solid seals, no curve holds the water: the grains do.
void seal_by_solids(const Problem& problem, const Particles& particles, const CellLists& lists,
                    const std::vector<TwoPhaseSums>& sums, const std::vector<std::uint8_t>& drawn,
                    NodeConditions& conditions);

} // namespace quicksand
