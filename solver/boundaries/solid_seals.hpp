// Nodes that soil shares with solids: grains and water move together there, so that no water enters a solid.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Set the conditions of the nodes from `drawn`, those of the curves, and the seals of solids, which the sums
/// tell by their drag; nothing is left of it. Where a solid seals, no curve holds the water: the grains do.
void seal_by_solids(const std::vector<std::uint8_t>& drawn, std::vector<TwoPhaseSums>& sums,
                    NodeConditions& conditions);

} // namespace quicksand
