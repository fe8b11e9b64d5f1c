// The set-up of the implicit pressure: its arrays, and the response of walls' rows.
#include "solver/water/pressure_solve.hpp"

#include <cmath>

namespace quicksand {

PressureSolve make_pressure_solve(std::size_t tiles, std::size_t cells, std::size_t nodes)
{
    PressureSolve solve;
    solve.divergence.resize(tiles);
    solve.partial.assign(tiles, 0.0);
    for (Scalars* by_cell :
         {&solve.storage, &solve.expected, &solve.increment, &solve.change, &solve.right_hand_side,
          &solve.diagonal, &solve.residual, &solve.answer, &solve.direction, &solve.product})
        by_cell->assign(cells, 0.0);
    for (Scalars* by_node : {&solve.force_x, &solve.force_y, &solve.flux_x, &solve.flux_y})
        by_node->assign(nodes, 0.0);
    return solve;
}

void add_cavities(PressureSolve& solve)
{
    CavitySolve& cavity = solve.cavity;
    for (Scalars* by_cell :
         {&cavity.deficit, &cavity.lowest_increment, &cavity.water_increment, &cavity.lacking})
        by_cell->assign(solve.storage.size(), 0.0);
    cavity.cavities.assign(solve.storage.size(), 0);
}

void choose_blocks(double dt, PressureSolve& solve)
{
    constexpr double alike = 0.5;               // of dt: the diagonal, by which blocks are scaled, follows it
    constexpr std::int32_t worth_a_set_up = 16; // iterations: their instructions are those of new blocks
    if (std::abs(dt - solve.dt_of_blocks) > alike * dt || solve.iterations_lost > worth_a_set_up)
        solve.blocks_are_due = true;
    if (solve.blocks_are_due) solve.dt_of_blocks = dt;
}

void set_row_response(const Scalars& porosities, VelocityRows& rows, PressureSolve& solve)
{
    solve.rows = rows.empty() ? nullptr : &rows;
    if (solve.blocks_are_due) {
        solve.following.clear();
        solve.held.clear();
    }
    if (rows.empty()) return;
    rows.set_porosities(porosities);
    const std::vector<Eigen::Matrix2d> local = rows.local_compliances();
    for (std::size_t k = 0; k < local.size(); ++k) {
        const std::size_t i = rows.nodes()[k];
        solve.compliance.xx[i] = local[k](0, 0);
        solve.compliance.xy[i] = local[k](0, 1);
        solve.compliance.yy[i] = local[k](1, 1);
    }
    if (!solve.blocks_are_due) return;
    rows.for_each_followed([&](std::size_t follower, int axis, std::size_t node, double weight) {
        if (axis >= 2) return; // of the water
        std::vector<FollowingNode>& following = solve.following;
        if (following.empty() || following.back().node != follower || following.back().axis != axis)
            following.push_back({follower, axis, {}});
        following.back().followed.push_back({node, weight});
    });
    solve.held = rows.held_rows();
}

} // namespace quicksand
