// Nodes to particles: velocities, their gradients and slopes, and the divergence of the flux of grains and
// water.
//
// Velocities. A particle keeps its own velocity and takes the change of the grid's (FLIP): taking the grid's
// velocity itself (PIC) would smooth the motion a little in every step, and the explicit step is so short
// that this would damp a shear wave of twenty cells by a per cent of critical, even with the slope carried
// along. What the grid cannot see of the particles' motion is noise, though; it is taken out at a rate, not
// per step:
//   v_p <- v + theta (v_grid - v),  theta = dt / (dt + tau),  tau = 20 h / c
// (c the fastest wave), and noise of the water relative to the grains, which drag at the nodes cannot reach,
// at the rate at which drag would: theta_r = a dt / (1 + a dt), a = C (1/r_s + 1/r_w). The relative velocity
// is corrected such that the momentum of both phases together is untouched.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// tau, the time over which velocity noise is taken out [s].
double noise_time(const Problem& problem);

/// For a tile's particles: v_p as above and the carried slopes C_p (carried_slope.hpp) of both phases; of the
/// grains L_s = sum v_i (x) grad phi, with which the domains deform, and grid_velocity = sum phi v_i, with
/// which they move [m/s]; flux_divergence = sum grad phi . [(1-n_i) v_s + n_i v_w] [1/s].
void gather_two_phase(const Problem& problem, double dt, double share, const CellLists& lists,
                      const Tile& tile, const PatchStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Vectors& grid_velocity, Scalars& flux_divergence);

/// The same for a body that moves as one phase.
void gather_single_phase(const Problem& problem, double share, const CellLists& lists, const Tile& tile,
                         const PatchStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles, Vectors& grid_velocity);

} // namespace quicksand
