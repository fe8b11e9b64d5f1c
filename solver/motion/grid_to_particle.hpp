// Nodes to particles: velocities, their gradients, affine velocities, and the divergence of the flux of
// grains and water.
//
// Velocities. A particle adds the change of the grid's velocity to its own (FLIP). The grid's velocity itself
// (PIC) would smooth the motion in every step; the explicit step is so short that a shear wave of twenty
// cells would have a damping ratio of one per cent, even with affine velocities. With FLIP, however,
// null-space modes of the particles' velocities, which have no effect on the nodes, persist. They decay over
// the time tau, not per step:
//   v_p <- v + theta (v_grid - v),  theta = dt / (dt + tau),  tau = 20 h / c
// (c the fastest wave). Null-space modes of the water's velocity relative to the grains, on which the drag at
// the nodes does not act, decay at the rate of drag: theta_r = a dt / (1 + a dt), a = C (1/r_s + 1/r_w). This
// correction keeps the momentum of both phases together.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// tau, the decay time of null-space modes of the velocity [s].
double null_space_time(const Problem& problem);

/// For a tile's particles: v_p as above with theta = `fraction`, the affine velocities C_p
/// (affine_velocity.hpp) of both phases; of the grains L_s = sum v_i (x) grad phi, with which the domains
/// deform, and grid_velocity = sum phi v_i, with which they move [m/s]; flux_divergence = sum grad phi .
/// [(1-n_i) v_s + n_i v_w] [1/s].
void gather_two_phase(const Problem& problem, double dt, double fraction, const CellLists& lists,
                      const Tile& tile, const StencilStore& store, const std::vector<TwoPhaseMotion>& motion,
                      Particles& particles, Vectors& grid_velocity, Scalars& flux_divergence);

/// The same for a body that moves as one phase.
void gather_single_phase(const Problem& problem, double fraction, const CellLists& lists, const Tile& tile,
                         const StencilStore& store, const std::vector<SinglePhaseMotion>& motion,
                         Particles& particles, Vectors& grid_velocity);

} // namespace quicksand
