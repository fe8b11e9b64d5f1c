// Nodes to particles: velocities, velocity gradients and the divergence of the flux of grains and water.
#pragma once

#include "solver/cell_lists.hpp"
#include "solver/node_weights.hpp"
#include "solver/nodes.hpp"
#include "solver/state.hpp"

#include <vector>

namespace quicksand {

/// v_p = sum phi v_i and L_p = sum v_i (x) grad phi for both phases of a tile's particles;
/// flux_divergence = sum grad phi . [(1-n_i) v_s + n_i v_w] [1/s].
void gather_two_phase(const BackgroundGrid& grid, const CellLists& lists, const Tile& tile,
                      const PatchStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Scalars& flux_divergence);

/// The same for a body that moves as one phase.
void gather_single_phase(const BackgroundGrid& grid, const CellLists& lists, const Tile& tile,
                         const PatchStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles);

} // namespace quicksand
