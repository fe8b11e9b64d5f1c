// What dashpots and moving walls do to the flux that a force of the pressure makes on a node: for the
// semi-implicit step, which solves for pressures whose fluxes it will find in its velocities afterwards.
#pragma once

#include "solver/boundary_conditions.hpp"
#include "solver/grid_momentum.hpp"
#include "solver/nodes.hpp"
#include "solver/viscous_boundary.hpp"

#include <array>
#include <vector>

namespace quicksand {

/// The impulse of a wall on its pair of nodes, in one direction, that a force of the pressure on them calls
/// up, and its flux: flux_b -= d sum_a (k_b . P k_a) F_a . d, with k of grains and water.
struct WallCompliance {
    std::array<std::size_t, 2> node = {0, 0}; // inner, outer
    Vector2 direction = Vector2::Zero();      // d [-]
    std::array<double, 2> solid = {0.0, 0.0}; // k: velocity at the wall per impulse of the pressure's force
    std::array<double, 2> fluid = {0.0, 0.0}; //    on a node [m/kg]
    double solid_solid = 0.0, solid_fluid = 0.0, fluid_fluid = 0.0; // P: impulse per velocity [kg/m]
};

/// Brake the compliances of the nodes that have dashpots.
void include_dashpots(const Problem& problem, const NodeConditions& conditions, double dt,
                      const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                      NodeCompliances& compliances);

/// The compliances of all moving walls.
std::vector<WallCompliance> wall_compliances(const Problem& problem, const NodeConditions& conditions,
                                             double dt, const std::vector<TwoPhaseSums>& sums);

} // namespace quicksand
