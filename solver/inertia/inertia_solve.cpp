#include "solver/inertia/inertia_solve.hpp"

namespace quicksand {

namespace {

/// Sum of work(span) over the spans, the same bits for any number of threads.
template <class Work>
double sum_over_spans(InertiaSolve& solve, Work&& work)
{
    solve.partial.assign(solve.spans.size(), 0.0);
    for_each_span(solve.spans, [&](std::size_t k) { solve.partial[k] = work(solve.spans[k]); });
    double sum = 0.0;
    for (const double part : solve.partial) sum += part;
    return sum;
}

} // namespace

InertiaSolve make_inertia_solve(const BackgroundGrid& grid, const NodeConditions& conditions)
{
    InertiaSolve solve;
    solve.rows = make_node_rows(grid);
    for (const TiedNodes& tie : conditions.tied)
        solve.tied.push_back({solve.rows.place(tie.node), solve.rows.place(tie.master)});
    return solve;
}

double multiply_stiffness(double factor, Vectors& field, InertiaSolve& solve)
{
    for (const TiedPlaces& tie : solve.tied) {
        field.x[tie.tied] = field.x[tie.master];
        field.y[tie.tied] = field.y[tie.master];
    }
    const double square = sum_over_spans(solve, [&](const NodeSpan& span) {
        return solve.stiffness.multiply(span, factor, field, solve.product);
    });
    for (const TiedPlaces& tie : solve.tied) {
        solve.product.x[tie.master] += solve.product.x[tie.tied];
        solve.product.y[tie.master] += solve.product.y[tie.tied];
        solve.product.x[tie.tied] = solve.product.y[tie.tied] = 0.0;
    }
    return square;
}

} // namespace quicksand
