#include "solver/inertia/inertia_solve.hpp"

namespace quicksand {

InertiaSolve make_inertia_solve(const BackgroundGrid& grid, const NodeConditions& conditions)
{
    InertiaSolve solve;
    solve.rows = make_node_rows(grid);
    for (const TiedNodes& tie : conditions.tied)
        solve.tied.push_back({solve.rows.place(tie.node), solve.rows.place(tie.master)});
    return solve;
}

void multiply_stiffness(double factor, Vectors& field, InertiaSolve& solve)
{
    for (const TiedPlaces& tie : solve.tied) {
        field.x[tie.tied] = field.x[tie.master];
        field.y[tie.tied] = field.y[tie.master];
    }
    solve.stiffness.multiply(factor, field, solve.product);
    for (const TiedPlaces& tie : solve.tied) {
        solve.product.x[tie.master] += solve.product.x[tie.tied];
        solve.product.y[tie.master] += solve.product.y[tie.tied];
        solve.product.x[tie.tied] = solve.product.y[tie.tied] = 0.0;
    }
}

} // namespace quicksand
