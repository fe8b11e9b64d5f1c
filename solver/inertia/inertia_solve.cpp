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

/// product += A direction; returns their sum of direction . A direction.
VECTOR_KERNEL
double add_masses(const NodeSpan& span, const PlaceTensors& mass, const Vectors& direction, Vectors& product)
{
    Lanes sum = all_lanes(0.0);
    for (std::size_t i = span.first; i < span.last; i += NodeRows::lanes) {
        const Lanes x = load_lanes(&direction.x[i]), y = load_lanes(&direction.y[i]);
        const Lanes xy = load_lanes(&mass.xy[i]);
        const Lanes of_x = load_lanes(&mass.xx[i]) * x + xy * y, of_y = xy * x + load_lanes(&mass.yy[i]) * y;
        store_lanes(load_lanes(&product.x[i]) + of_x, &product.x[i]);
        store_lanes(load_lanes(&product.y[i]) + of_y, &product.y[i]);
        sum += x * of_x + y * of_y;
    }
    return sum_of(sum);
}

/// change += step direction, residual -= step product, answer = A^-1 residual; returns residual . answer.
VECTOR_KERNEL
double advance_span(const NodeSpan& span, double step, const PlaceTensors& response, const Vectors& direction,
                    const Vectors& product, Vectors& change, Vectors& residual, Vectors& answer)
{
    Lanes sum = all_lanes(0.0);
    const Lanes steps = all_lanes(step);
    for (std::size_t i = span.first; i < span.last; i += NodeRows::lanes) {
        store_lanes(load_lanes(&change.x[i]) + steps * load_lanes(&direction.x[i]), &change.x[i]);
        store_lanes(load_lanes(&change.y[i]) + steps * load_lanes(&direction.y[i]), &change.y[i]);
        const Lanes x = load_lanes(&residual.x[i]) - steps * load_lanes(&product.x[i]);
        const Lanes y = load_lanes(&residual.y[i]) - steps * load_lanes(&product.y[i]);
        const Lanes xy = load_lanes(&response.xy[i]);
        const Lanes of_x = load_lanes(&response.xx[i]) * x + xy * y,
                    of_y = xy * x + load_lanes(&response.yy[i]) * y;
        store_lanes(x, &residual.x[i]);
        store_lanes(y, &residual.y[i]);
        store_lanes(of_x, &answer.x[i]);
        store_lanes(of_y, &answer.y[i]);
        sum += x * of_x + y * of_y;
    }
    return sum_of(sum);
}

/// direction = answer + beta direction
VECTOR_KERNEL
void turn_span(const NodeSpan& span, double beta, const Vectors& answer, Vectors& direction)
{
    const Lanes betas = all_lanes(beta);
    for (std::size_t i = span.first; i < span.last; i += NodeRows::lanes) {
        store_lanes(load_lanes(&answer.x[i]) + betas * load_lanes(&direction.x[i]), &direction.x[i]);
        store_lanes(load_lanes(&answer.y[i]) + betas * load_lanes(&direction.y[i]), &direction.y[i]);
    }
}

NodeVelocities with_water(const Vectors& grains, const RowNode& node, const Vector2& water)
{
    return {grains.x[node.place], grains.y[node.place], water.x(), water.y()};
}

void spread_to_tied(const InertiaSolve& solve, Vectors& field)
{
    for (const TiedPlaces& tie : solve.tied) {
        field.x[tie.tied] = field.x[tie.master];
        field.y[tie.tied] = field.y[tie.master];
    }
}

void gather_from_tied(const InertiaSolve& solve, Vectors& field)
{
    for (const TiedPlaces& tie : solve.tied) {
        field.x[tie.master] += field.x[tie.tied];
        field.y[tie.master] += field.y[tie.tied];
        field.x[tie.tied] = field.y[tie.tied] = 0.0;
    }
}

/// product = (A + b K) direction; returns direction . product.
double multiply(double factor, InertiaSolve& solve)
{
    spread_to_tied(solve, solve.direction);
    double sum = sum_over_spans(solve, [&](const NodeSpan& span) {
        const double of_stiffness = solve.stiffness.multiply(span, factor, solve.direction, solve.product);
        return of_stiffness + add_masses(span, solve.mass, solve.direction, solve.product);
    });
    gather_from_tied(solve, solve.product);
    for (RowNode& node : solve.row_nodes) {
        const NodeVelocities direction = with_water(solve.direction, node, node.direction);
        const NodeVelocities product = node.mass * direction;
        solve.product.x[node.place] += product[0];
        solve.product.y[node.place] += product[1];
        node.product = product.tail<2>();
        sum += direction.dot(product);
    }
    return sum;
}

/// The answers of the nodes of rows; returns residual . answer.
double answer_at_rows(InertiaSolve& solve)
{
    if (solve.held == nullptr) return 0.0;
    solve.at_rows.clear();
    for (std::size_t k = 0; k < solve.row_nodes.size(); ++k)
        solve.at_rows.push_back(solve.held->inverse(k) *
                                with_water(solve.residual, solve.row_nodes[k], solve.row_nodes[k].residual));
    solve.held->project(solve.at_rows);
    double sum = 0.0;
    for (std::size_t k = 0; k < solve.row_nodes.size(); ++k) {
        const RowNode& node = solve.row_nodes[k];
        solve.answer.x[node.place] = solve.at_rows[k][0];
        solve.answer.y[node.place] = solve.at_rows[k][1];
        sum += solve.at_rows[k].dot(with_water(solve.residual, node, node.residual));
    }
    return sum;
}

/// A step along the direction; returns residual . answer after it.
double advance(double step, InertiaSolve& solve)
{
    const double sum = sum_over_spans(solve, [&](const NodeSpan& span) {
        return advance_span(span, step, solve.response, solve.direction, solve.product, solve.change,
                            solve.residual, solve.answer);
    });
    for (RowNode& node : solve.row_nodes) {
        node.change += step * node.direction;
        node.residual -= step * node.product;
    }
    return sum + answer_at_rows(solve);
}

void turn_direction(double beta, InertiaSolve& solve)
{
    for_each_span(solve.spans,
                  [&](std::size_t k) { turn_span(solve.spans[k], beta, solve.answer, solve.direction); });
    for (std::size_t k = 0; k < solve.row_nodes.size(); ++k) {
        RowNode& node = solve.row_nodes[k];
        node.direction = solve.at_rows[k].tail<2>() + beta * node.direction;
    }
}

/// residual = A w_0, change = 0; returns residual . A^-1 residual.
double begin(InertiaSolve& solve)
{
    for (Vectors* field : {&solve.change, &solve.direction, &solve.product, &solve.residual}) {
        field->x.assign(solve.rows.size(), 0.0);
        field->y.assign(solve.rows.size(), 0.0);
    }
    for (Scalars* part : {&solve.answer.x, &solve.answer.y}) part->resize(solve.rows.size());
    for_each_span(solve.spans, [&](std::size_t k) {
        add_masses(solve.spans[k], solve.mass, solve.wanted, solve.residual);
    });
    for (RowNode& node : solve.row_nodes) {
        const NodeVelocities impulse = node.mass * node.wanted;
        solve.residual.x[node.place] = impulse[0];
        solve.residual.y[node.place] = impulse[1];
        node.residual = impulse.tail<2>();
        node.change = node.direction = node.product = Vector2::Zero();
    }
    return advance(0.0, solve);
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

bool solve_change(double factor, const InertiaControls& controls, InertiaSolve& solve)
{
    double error = begin(solve), before = 0.0;
    const double target = controls.tolerance * controls.tolerance * error;
    for (solve.iterations = 0; error > target; ++solve.iterations) {
        if (solve.iterations == controls.max_iterations) return false;
        turn_direction(solve.iterations == 0 ? 0.0 : error / before, solve);
        const double curvature = multiply(factor, solve);
        if (!(curvature > 0.0)) return false;
        before = error;
        error = advance(error / curvature, solve);
    }
    return error <= target; // not so where it is not a number
}

void multiply_change(double factor, InertiaSolve& solve)
{
    spread_to_tied(solve, solve.change);
    for_each_span(solve.spans, [&](std::size_t k) {
        solve.stiffness.multiply(solve.spans[k], factor, solve.change, solve.product);
    });
    gather_from_tied(solve, solve.product);
}

} // namespace quicksand
