#include "solver/inertia/node_masses.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"

namespace quicksand {

std::vector<TwoPhaseMotion> velocities_before(const Problem& problem, const NodeConditions& conditions,
                                              const WallRows& walls, const std::vector<TwoPhaseSums>& sums)
{
    std::vector<TwoPhaseMotion> before(sums.size());
    solve_two_phase_momentum(problem, conditions, 0.0, 0.0, sums, before);
    hold_at_walls(problem, sums, walls, before);
    return before;
}

std::vector<SinglePhaseMotion> velocities_before(const Problem& problem, const NodeConditions& conditions,
                                                 const WallRows& walls,
                                                 const std::vector<SinglePhaseSums>& sums)
{
    std::vector<SinglePhaseMotion> before(sums.size());
    solve_single_phase_momentum(problem, conditions, 0.0, 0.0, 0.0, sums, before);
    hold_at_walls(walls, before);
    return before;
}

NodeInverse mass_matrix(const TwoPhaseSums& node, double dt)
{
    const Eigen::Matrix2d drag = dt * drag_tensor(node), unit = Eigen::Matrix2d::Identity();
    return (NodeInverse() << node.mass_solid * unit + drag, -drag, -drag, node.mass_fluid * unit + drag)
        .finished();
}

Eigen::Matrix2d half_braking(const Dashpot& dashpot, double dt)
{
    return 0.5 * dt * (Eigen::Matrix2d() << dashpot.xx, dashpot.xy, dashpot.xy, dashpot.yy).finished();
}

} // namespace quicksand
