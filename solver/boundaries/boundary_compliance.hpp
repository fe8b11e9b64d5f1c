// What dashpots do to the flux that a force of the pressure makes on a node: for the
// semi-implicit step, which solves for pressures whose fluxes it will find in its velocities afterwards.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/boundaries/viscous_boundary.hpp"

#include <vector>

namespace quicksand {

/// Brake the compliances of the nodes that have dashpots.
void include_dashpots(const Problem& problem, const NodeConditions& conditions, double dt,
                      const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                      NodeCompliances& compliances);

} // namespace quicksand
