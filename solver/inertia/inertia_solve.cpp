#include "solver/inertia/inertia_solve.hpp"

#include <algorithm>
#include <iterator>

namespace quicksand {

InertiaSolve make_inertia_solve(const Problem& problem, const NodeConditions& conditions, Stage stage)
{
    InertiaSolve solve;
    for (const Material& material : problem.materials)
        solve.resists.push_back(stage == Stage::shaking || !material.has_pores ? 1 : 0);
    solve.rows = make_node_rows(problem.grid);
    for (std::size_t node = 0; node < solve.rows.nodes_x * solve.rows.nodes_y; ++node)
        solve.places.push_back(solve.rows.place(node));
    for (const TiedNodes& tie : conditions.tied)
        solve.tied.push_back({solve.rows.place(tie.node), solve.rows.place(tie.master)});
    return solve;
}

bool is_resisted(const InertiaSolve& solve, std::size_t node)
{
    const std::size_t place = solve.places[node], stride = solve.rows.stride;
    const std::size_t cells[] = {place, place - 1, place - stride, place - stride - 1};
    return std::any_of(std::begin(cells), std::end(cells),
                       [&](std::size_t cell) { return solve.cells.constrained[cell] > 0.0; });
}

std::vector<ThreeNodeCell> take_incomplete_cells(std::vector<ThreeNodeCell> corners, CellModuli& cells)
{
    std::sort(corners.begin(), corners.end(),
              [](const ThreeNodeCell& a, const ThreeNodeCell& b) { return a.place < b.place; });
    std::vector<ThreeNodeCell> with_three_nodes;
    for (std::size_t k = 0, end = 0; k < corners.size(); k = end) {
        const std::size_t place = corners[k].place;
        while (end < corners.size() && corners[end].place == place) ++end;
        if (end == k + 1)
            with_three_nodes.push_back(
                {place, corners[k].missing, cells.constrained[place], cells.shear[place]});
        cells.constrained[place] = cells.shear[place] = 0.0;
    }
    return with_three_nodes;
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
