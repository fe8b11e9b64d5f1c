// Nodes that belong to several walls of different directions: the corners of a section, and what lies beyond.
#pragma once

#include "solver/boundary_conditions.hpp"

namespace quicksand {

/// Put the conditions on a node together where a slanted wall meets another one: grains that two walls hold
/// are held, and so is water that two keep in; walls that turn by less than 45 degrees are one with the
/// normal between theirs. Afterwards a node has conditions in NodeConditions::of_node or one slanted wall,
/// not both. Where a drained slanted wall meets a sealed free curve, which one direction cannot say, the film
/// is along the wall.
void merge_corners(NodeConditions& conditions);

/// The conditions of a wall along x, for one along y.
std::uint8_t turned(std::uint8_t conditions);

} // namespace quicksand
