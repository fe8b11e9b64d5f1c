#include "solver/boundaries/boundary_compliance.hpp"

#include "solver/boundaries/node_response.hpp"

namespace quicksand {

namespace {

/// Velocities of grains and water per impulse of the pressure's force, which acts on them as 1-n and n.
NodeResponse pressure_response(double n, const NodeResponse& response)
{
    return {(1.0 - n) * response.solid + n * response.exchange, 0.0,
            (1.0 - n) * response.exchange + n * response.fluid};
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
        const std::uint8_t held = conditions.of_node[i];
        const NodeResponse x = response(sums[i], dt, held, 0), y = response(sums[i], dt, held, 1);
        Eigen::Matrix2d K = Eigen::Matrix2d::Zero();
        K.diagonal() << pressure_response(n, x).solid, pressure_response(n, y).solid;
        const Braking braking = braking_of(dashpot, dt, x, y);
        const Eigen::Matrix2d change = K * braking.half * braking.left * K;
        compliances.xx[i] -= change(0, 0);
        compliances.xy[i] -= 0.5 * (change(0, 1) + change(1, 0)); // equal but for rounding
        compliances.yy[i] -= change(1, 1);
    }
}

} // namespace quicksand
