// The mass balance of the water.
#pragma once

#include "solver/cell_lists.hpp"
#include "solver/problem.hpp"
#include "solver/state.hpp"

namespace quicksand {

/// Add the pressure of a step to the particles of a tile, one increment per cell (the cure for volumetric
/// locking and its noise: the pressure is as rich as the cells, not as the particles):
///   dp = - dt K_w  sum V_p div[(1-n) v_s + n v_w] / sum n_p V_p
/// and, since the excess is counted from a static pressure that falls with height, dp += dt rho_w g v_y.
void update_pore_pressure(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                          const Scalars& flux_divergence, Particles& particles);

} // namespace quicksand
