// The effect of dashpots on the flux at a node due to a force of the pressure, for the
// semi-implicit step: its pressures must fit the velocities that include the dashpots.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/boundaries/viscous_boundary.hpp"

#include <vector>

namespace quicksand {

/// Reduce the compliances of the nodes that have dashpots.
void include_dashpots(const Problem& problem, const NodeConditions& conditions, double dt,
                      const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                      NodeCompliances& compliances);

} // namespace quicksand
