// Particles to nodes: masses, momenta, internal forces and drag, tile by tile.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Inertia and weight of the particles when the body moves as one phase.
struct CarriedMasses {
    Scalars inertia; // mass that is accelerated [kg/m]
    Scalars weight;  // mass that gravity acts on, less the water it displaces [kg/m]
};

/// Dry: both are the grains' mass. With water: inertia of grains and water, weight buoyant below the water
/// level. Water fills the pores, unless it is kept from leaving them: in undrained shaking its mass is
/// constant.
void compute_carried_masses(const Problem& problem, const State& state, CarriedMasses& masses);

/// Weights of the particles of a tile, in the order of the lists. Returns how many domains were shortened.
std::int64_t evaluate_weights(const Problem& problem, const Particles& particles, const CellLists& lists,
                              const Tile& tile, StencilStore& store);

/// Add the particles of a tile to the nodes' sums. Velocities are affine
/// (affine_velocity.hpp): the particle gives node i the velocity v_p + C_p (x_i - x_p).
void scatter_two_phase(const Problem& problem, const Particles& particles, const CellLists& lists,
                       const Tile& tile, const StencilStore& store, std::vector<TwoPhaseSums>& sums);

void scatter_single_phase(const Problem& problem, const Particles& particles, const CarriedMasses& masses,
                          const CellLists& lists, const Tile& tile, const StencilStore& store,
                          std::vector<SinglePhaseSums>& sums);

/// The same with the total stress, sigma' - p I.
void scatter_total_stress(const Problem& problem, const Particles& particles, const CarriedMasses& masses,
                          const CellLists& lists, const Tile& tile, const StencilStore& store,
                          std::vector<SinglePhaseSums>& sums);

/// Saturated soil above the water level has no static pressure to be buoyant in: take the lift that
/// solve_two_phase_momentum reckons with out again, as a force of the pressure. `outer` notes its size.
void scatter_risen_water(const Problem& problem, const Particles& particles, const CellLists& lists,
                         const Tile& tile, const StencilStore& store, std::vector<TwoPhaseSums>& sums,
                         std::vector<OuterForce>& outer);

/// Whether any excess pore pressure acts.
bool has_pressure(const Particles& particles);

/// Add the problem's own body force at `time` [s].
void scatter_body_force(const Problem& problem, double time, const Particles& particles,
                        const CarriedMasses& masses, const CellLists& lists, const Tile& tile,
                        const StencilStore& store, std::vector<SinglePhaseSums>& sums);

} // namespace quicksand
