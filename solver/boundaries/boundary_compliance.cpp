#include "solver/boundaries/boundary_compliance.hpp"

#include "solver/boundaries/node_response.hpp"

namespace quicksand {

namespace {

/// Velocity of the grains per impulse of the pressure's force, which acts on grains and water as 1-n and n.
Eigen::Matrix2d pressure_response(double n, const NodeResponses& responses)
{
    return (1.0 - n) * responses.solid + n * responses.exchange;
}

} // namespace

void include_dashpots(const Problem& problem, const NodeConditions& conditions, double dt,
                      const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                      NodeCompliances& compliances)
{
    for (const Dashpot& dashpot : dashpots) {
        const std::size_t i = dashpot.node;
        if (!sums[i].active()) continue;
        const double n = node_porosity(problem, sums[i]);
        const NodeResponses r = responses(sums[i], dt, conditions.of_node[i]);
        const Eigen::Matrix2d K = pressure_response(n, r);
        const Braking braking = braking_of(dashpot, dt, r);
        const Eigen::Matrix2d change = K * braking.half * braking.left * K;
        compliances.xx[i] -= change(0, 0);
        compliances.xy[i] -= 0.5 * (change(0, 1) + change(1, 0)); // equal but for rounding
        compliances.yy[i] -= change(1, 1);
    }
}

} // namespace quicksand
