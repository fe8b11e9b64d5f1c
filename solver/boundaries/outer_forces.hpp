// What acts on the nodes from beyond the boundary curves: loads, water, held reactions and free fields.
#pragma once

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// Whether anything on the boundary curves acts on the nodes.
bool has_outer_forces(const Problem& problem);

/// Find all forces on the nodes, those of loads and of water at `time` [s].
void gather_outer_forces(const Problem& problem, double time, const State& state, ParticlePlaces& places,
                         std::vector<NodalForce>& forces);

/// Add them to the sums of the nodes. A body of one phase takes those on the mixture whole.
void add_outer_forces(const std::vector<NodalForce>& forces, std::vector<TwoPhaseSums>& sums);
void add_outer_forces(const std::vector<NodalForce>& forces, std::vector<SinglePhaseSums>& sums);

/// Keep them apart for the balances.
void note_outer_forces(const std::vector<NodalForce>& forces, std::vector<OuterForce>& outer);

} // namespace quicksand
