#include "solver/inertia/inertia_solve.hpp"

#include "solver/base/lanes.hpp"

#include <algorithm>

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

inline double sum_of(const Lanes& lanes)
{
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

VECTOR_KERNEL
double dot_span(const NodeSpan& span, const Vectors& a, const Vectors& b)
{
    Lanes sum = all_lanes(0.0);
    for (std::size_t i = span.first; i < span.last; i += NodeRows::lanes)
        sum += load_lanes(&a.x[i]) * load_lanes(&b.x[i]) + load_lanes(&a.y[i]) * load_lanes(&b.y[i]);
    return sum_of(sum);
}

/// target = first + factor target
VECTOR_KERNEL
void turn_span(const NodeSpan& span, double factor, const Vectors& first, Vectors& target)
{
    const Lanes factors = all_lanes(factor);
    for (std::size_t i = span.first; i < span.last; i += NodeRows::lanes) {
        store_lanes(load_lanes(&first.x[i]) + factors * load_lanes(&target.x[i]), &target.x[i]);
        store_lanes(load_lanes(&first.y[i]) + factors * load_lanes(&target.y[i]), &target.y[i]);
    }
}

/// change += step direction, residual -= step (impulse + product)
VECTOR_KERNEL
void advance_span(const NodeSpan& span, double step, const Vectors& direction, const Vectors& impulse,
                  const Vectors& product, Vectors& change, Vectors& residual)
{
    const Lanes steps = all_lanes(step);
    for (std::size_t i = span.first; i < span.last; i += NodeRows::lanes) {
        store_lanes(load_lanes(&change.x[i]) + steps * load_lanes(&direction.x[i]), &change.x[i]);
        store_lanes(load_lanes(&change.y[i]) + steps * load_lanes(&direction.y[i]), &change.y[i]);
        const Lanes of_x = load_lanes(&impulse.x[i]) + load_lanes(&product.x[i]),
                    of_y = load_lanes(&impulse.y[i]) + load_lanes(&product.y[i]);
        store_lanes(load_lanes(&residual.x[i]) - steps * of_x, &residual.x[i]);
        store_lanes(load_lanes(&residual.y[i]) - steps * of_y, &residual.y[i]);
    }
}

double dot(const Vectors& a, const Vectors& b, InertiaSolve& solve)
{
    return sum_over_spans(solve, [&](const NodeSpan& span) { return dot_span(span, a, b); });
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

bool solve_change(double factor, const NodeResponseOfStep& respond, const InertiaControls& controls,
                  InertiaSolve& solve)
{
    respond(solve.residual, solve.answer);
    double error = dot(solve.residual, solve.answer, solve), before = 0.0;
    solve.scale = std::max(solve.scale, error);
    const double target = controls.tolerance * controls.tolerance * solve.scale;
    for (solve.iterations = 0; error > target; ++solve.iterations) {
        if (solve.iterations == controls.max_iterations) return false;
        const double beta = solve.iterations == 0 ? 0.0 : error / before;
        for_each_span(solve.spans, [&](std::size_t k) {
            turn_span(solve.spans[k], beta, solve.answer, solve.direction);
            turn_span(solve.spans[k], beta, solve.residual, solve.impulse);
        });
        const double of_stiffness = multiply_stiffness(factor, solve.direction, solve);
        const double curvature = dot(solve.direction, solve.impulse, solve) + of_stiffness;
        if (!(curvature > 0.0)) return false;
        const double step = error / curvature;
        for_each_span(solve.spans, [&](std::size_t k) {
            advance_span(solve.spans[k], step, solve.direction, solve.impulse, solve.product, solve.change,
                         solve.residual);
        });
        respond(solve.residual, solve.answer);
        before = error;
        error = dot(solve.residual, solve.answer, solve);
    }
    return error <= target; // not so where it is not a number
}

} // namespace quicksand
