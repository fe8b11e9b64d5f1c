// The reactions at a viscous curve from the settling of the soil.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Keep the forces that hold the viscous curves of a state at rest: fills State::reactions, one force for
/// each piece, whose sums at the nodes are the held nodes' forces. Nothing without viscous curves.
void hold_reactions(const Problem& problem, State& state);

} // namespace quicksand
