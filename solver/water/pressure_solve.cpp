#include "solver/water/pressure_solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

/// Call work(divergence, stencil, slot) for the cells of a tile that hold soil.
template <class Work>
void for_each_stencil(const PressureSolve& solve, const Tile& tile, Work&& work)
{
    const TileDivergence& divergence = solve.divergence[static_cast<std::size_t>(tile.number)];
    for (const CellStencil& stencil : divergence.stencils)
        work(divergence, stencil, static_cast<std::size_t>(stencil.cell));
}

/// Whether the pressure of a cell is that of the limit of tension.
bool is_held(const PressureSolve& solve, std::size_t c)
{
    return !solve.cavity.cavities.empty() && solve.cavity.cavities[c] != 0;
}

/// Sum of work(tile) over the tiles, the same bits for any number of threads.
template <class Work>
double sum_over_tiles(const CellLists& lists, PressureSolve& solve, Work&& work)
{
    for_each_tile(
        lists, [&](const Tile& tile) { solve.partial[static_cast<std::size_t>(tile.number)] = work(tile); });
    double sum = 0.0;
    for (const double part : solve.partial) sum += part;
    return sum;
}

void gather_tied_forces(const NodeConditions& conditions, PressureSolve& solve)
{
    for (const TiedNodes& tie : conditions.tied) {
        solve.force_x[tie.master] += solve.force_x[tie.node];
        solve.force_y[tie.master] += solve.force_y[tie.node];
    }
}

/// The fluxes of the nodes of the rows, from the forces on them.
void respond_by_rows(PressureSolve& solve)
{
    const std::vector<std::size_t>& nodes = solve.rows->nodes();
    solve.row_fluxes.resize(nodes.size());
    solve.rows->respond_to_pressure(solve.row_forces, solve.row_fluxes);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        solve.flux_x[nodes[k]] = solve.row_fluxes[k].x();
        solve.flux_y[nodes[k]] = solve.row_fluxes[k].y();
    }
}

void note_row_forces(PressureSolve& solve)
{
    solve.row_forces.clear();
    for (const std::size_t i : solve.rows->nodes())
        solve.row_forces.emplace_back(solve.force_x[i], solve.force_y[i]);
}

/// Badly filled cells get what their roots have.
void copy_from_roots(const PressureSolve& solve, Scalars& values)
{
    for (const AggregatedCell& cell : solve.aggregated)
        values[static_cast<std::size_t>(cell.slot)] = values[static_cast<std::size_t>(cell.root)];
}

/// Roots get what their badly filled cells have besides.
void sum_to_roots(const PressureSolve& solve, Scalars& values)
{
    for (const AggregatedCell& cell : solve.aggregated) {
        values[static_cast<std::size_t>(cell.root)] += values[static_cast<std::size_t>(cell.slot)];
        values[static_cast<std::size_t>(cell.slot)] = 0.0;
    }
}

/// The nodes' own answer, and that of the rows where there are some.
void respond_by_nodes(PressureSolve& solve)
{
    if (solve.rows != nullptr) note_row_forces(solve);
    const NodeCompliances& W = solve.compliance;
    for_each_index(solve.force_x.size(), [&](std::size_t i) {
        const double x = solve.force_x[i], y = solve.force_y[i];
        solve.flux_x[i] = W.xx[i] * x + W.xy[i] * y;
        solve.flux_y[i] = W.xy[i] * x + W.yy[i] * y;
        solve.force_x[i] = 0.0;
        solve.force_y[i] = 0.0;
    });
    if (solve.rows != nullptr) respond_by_rows(solve);
}

/// flux = W force at the nodes, tied nodes with the flux of their masters; the forces are zero afterwards.
void respond_to_forces(const NodeConditions& conditions, PressureSolve& solve)
{
    gather_tied_forces(conditions, solve);
    if (solve.stiff_response) {
        solve.stiff_response(solve.force_x, solve.force_y, solve.flux_x, solve.flux_y);
        std::fill(solve.force_x.begin(), solve.force_x.end(), 0.0);
        std::fill(solve.force_y.begin(), solve.force_y.end(), 0.0);
    } else {
        respond_by_nodes(solve);
    }
    for (const TiedNodes& tie : conditions.tied) {
        solve.flux_x[tie.node] = solve.flux_x[tie.master];
        solve.flux_y[tie.node] = solve.flux_y[tie.master];
    }
}

/// force += D^T pressure. The forces must be zero before.
void scatter_pressure(const BackgroundGrid& grid, const CellLists& lists, const Scalars& pressure,
                      PressureSolve& solve)
{
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        add_pressure_forces(solve.divergence[static_cast<std::size_t>(tile.number)], grid.nodes_x(), pressure,
                            solve.force_x, solve.force_y);
    });
}

/// product = L pressure; returns pressure . product. Badly filled cells get the pressure of their roots.
double multiply(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions,
                double dt, Scalars& pressure, PressureSolve& solve)
{
    copy_from_roots(solve, pressure);
    scatter_pressure(grid, lists, pressure, solve);
    respond_to_forces(conditions, solve);
    const double square = sum_over_tiles(lists, solve, [&](const Tile& tile) {
        const TileDivergence& divergence = solve.divergence[static_cast<std::size_t>(tile.number)];
        outflows(divergence, grid.nodes_x(), solve.flux_x, solve.flux_y, solve.product);
        double sum = 0.0;
        for (const CellStencil& stencil : divergence.stencils) {
            const auto c = static_cast<std::size_t>(stencil.cell);
            solve.product[c] = solve.storage[c] * pressure[c] + dt * dt * solve.product[c];
            sum += pressure[c] * solve.product[c];
        }
        return sum;
    });
    sum_to_roots(solve, solve.product);
    return square;
}

/// Diagonal of L; where nodes are tied to others that the same cell touches it is a little off, which costs
/// the preconditioner nothing.
void set_diagonal(const BackgroundGrid& grid, const CellLists& lists, double dt, PressureSolve& solve)
{
    const NodeCompliances& W = solve.compliance;
    const auto nodes_x = static_cast<std::size_t>(grid.nodes_x());
    for_each_tile(lists, [&](const Tile& tile) {
        for_each_stencil(solve, tile, [&](const TileDivergence& D, const CellStencil& cell, std::size_t c) {
            double sum = 0.0;
            auto k = static_cast<std::size_t>(cell.first);
            for (std::size_t b = 0; b < static_cast<std::size_t>(cell.height); ++b) {
                std::size_t i = static_cast<std::size_t>(cell.base) + b * nodes_x;
                for (std::int16_t a = 0; a < cell.width; ++a, ++k, ++i) {
                    sum += D.x[k] * (W.xx[i] * D.x[k] + 2.0 * W.xy[i] * D.y[k]) + D.y[k] * W.yy[i] * D.y[k];
                }
            }
            solve.diagonal[c] = solve.storage[c] + dt * dt * sum;
        });
    });
    sum_to_roots(solve, solve.diagonal);
    copy_from_roots(solve, solve.diagonal); // nothing is divided by zero
}

/// Sum of residual^2 / diagonal after residual(cell) has been set: the measure of convergence.
template <class Set>
double set_residual(const CellLists& lists, PressureSolve& solve, Set&& set)
{
    return sum_over_tiles(lists, solve, [&](const Tile& tile) {
        double sum = 0.0;
        for_each_stencil(solve, tile, [&](const TileDivergence&, const CellStencil&, std::size_t c) {
            set(c);
            sum += solve.residual[c] * (solve.residual[c] / solve.diagonal[c]);
        });
        return sum;
    });
}

/// answer = M^-1 residual; returns residual . answer. Cells that have got soil since the blocks were set up
/// are divided by their diagonal.
double answer_residual(const CellLists& lists, PressureSolve& solve)
{
    precondition(solve.residual, solve.blocks, solve.answer);
    return sum_over_tiles(lists, solve, [&](const Tile& tile) {
        double sum = 0.0;
        for_each_stencil(solve, tile, [&](const TileDivergence&, const CellStencil&, std::size_t c) {
            if (solve.blocks.blocks_of_slot[c] == 0) solve.answer[c] = solve.residual[c] / solve.diagonal[c];
            if (!solve.stiffness.empty()) solve.answer[c] += solve.stiffness[c] * solve.residual[c];
            if (is_held(solve, c)) solve.answer[c] = 0.0;
            sum += solve.residual[c] * solve.answer[c];
        });
        return sum;
    });
}

void turn_direction(const CellLists& lists, double beta, PressureSolve& solve)
{
    for_each_tile(lists, [&](const Tile& tile) {
        for_each_stencil(solve, tile, [&](const TileDivergence&, const CellStencil&, std::size_t c) {
            solve.direction[c] = solve.answer[c] + beta * solve.direction[c];
        });
    });
}

/// - dt D flux* - known(cell); returns its square, weighted by the diagonal.
template <class Known>
double set_right_hand_side(const BackgroundGrid& grid, const CellLists& lists, double dt, Known&& known,
                           PressureSolve& solve)
{
    return sum_over_tiles(lists, solve, [&](const Tile& tile) {
        const TileDivergence& divergence = solve.divergence[static_cast<std::size_t>(tile.number)];
        std::fill(solve.residual.begin() + tile.first_cell, solve.residual.begin() + tile.last_cell, 0.0);
        outflows(divergence, grid.nodes_x(), solve.flux_x, solve.flux_y, solve.right_hand_side);
        double sum = 0.0;
        for (const CellStencil& stencil : divergence.stencils) {
            const auto c = static_cast<std::size_t>(stencil.cell);
            solve.right_hand_side[c] = -dt * solve.right_hand_side[c] - known(c);
            sum += solve.right_hand_side[c] * (solve.right_hand_side[c] / solve.diagonal[c]);
        }
        return sum;
    });
}

/// What increments leave, of which lacking(cell) is asked; returns the measure of convergence.
template <class Lacking>
double begin_residual(const CellLists& lists, PressureSolve& solve, Lacking&& lacking)
{
    return set_residual(lists, solve, [&](std::size_t c) {
        const double left = lacking(c);
        solve.residual[c] = is_held(solve, c) ? 0.0 : left;
        if (is_held(solve, c)) solve.cavity.lacking[c] = left;
    });
}

/// What the present increments leave; all of it where they are zero, as without cavities.
double residual_of_increments(const BackgroundGrid& grid, const CellLists& lists,
                              const NodeConditions& conditions, double dt, PressureSolve& solve)
{
    const bool are_zero = std::all_of(solve.increment.begin(), solve.increment.end(),
                                      [](double increment) { return increment == 0.0; });
    if (are_zero)
        return begin_residual(lists, solve, [&](std::size_t c) { return solve.right_hand_side[c]; });
    multiply(grid, lists, conditions, dt, solve.increment, solve);
    return begin_residual(lists, solve,
                          [&](std::size_t c) { return solve.right_hand_side[c] - solve.product[c]; });
}

/// Conjugate gradients from the present increments, which leave the residual, and a measure of it; those of
/// cells with cavities stay.
bool iterate(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions, double dt,
             double error, double target, const PressureSolveControls& controls, PressureSolve& solve)
{
    double weight = 0.0; // residual . M^-1 residual
    for (bool first = true; error > target; first = false, ++solve.iterations) {
        if (solve.iterations == controls.max_iterations) return false;
        const double last = std::exchange(weight, answer_residual(lists, solve));
        if (weight == 0.0)
            return true; // less than single precision knows: water that nothing has reached yet
        turn_direction(lists, first ? 0.0 : weight / last, solve);
        const double alpha = weight / multiply(grid, lists, conditions, dt, solve.direction, solve);
        error = set_residual(lists, solve, [&](std::size_t c) {
            if (is_held(solve, c)) {
                solve.cavity.lacking[c] -= alpha * solve.product[c];
                return;
            }
            solve.increment[c] += alpha * solve.direction[c];
            solve.residual[c] -= alpha * solve.product[c];
        });
    }
    return std::isfinite(error);
}

/// The cells that begin the step with cavities, at the pressure of the limit; in all others the water first
/// fills what is missing to it.
void begin_cavities(const CellLists& lists, PressureSolve& solve)
{
    CavitySolve& cavity = solve.cavity;
    for_each_tile(lists, [&](const Tile& tile) {
        for_each_stencil(solve, tile, [&](const TileDivergence&, const CellStencil&, std::size_t c) {
            solve.right_hand_side[c] += solve.storage[c] * cavity.deficit[c];
            cavity.cavities[c] = cavity.deficit[c] < cavity.lowest_increment[c] ? 1 : 0;
            if (cavity.cavities[c] != 0) solve.increment[c] = cavity.lowest_increment[c];
        });
    });
}

/// What the water's volume asks for, and the cells with cavities that follow from it; returns whether they
/// are others than before.
bool revise_cavities(const CellLists& lists, PressureSolve& solve)
{
    CavitySolve& cavity = solve.cavity;
    const double changes = sum_over_tiles(lists, solve, [&](const Tile& tile) {
        double changed = 0.0;
        for_each_stencil(solve, tile, [&](const TileDivergence&, const CellStencil&, std::size_t c) {
            const double beyond = is_held(solve, c) ? cavity.lacking[c] / solve.storage[c] : 0.0;
            cavity.water_increment[c] = solve.increment[c] + beyond - cavity.deficit[c];
            const bool held = solve.increment[c] + beyond < cavity.lowest_increment[c];
            if (held == is_held(solve, c)) return;
            cavity.cavities[c] = held ? 1 : 0;
            if (held) solve.increment[c] = cavity.lowest_increment[c];
            changed += 1.0;
        });
        return changed;
    });
    return changes > 0.0;
}

/// Iterate until the cells with cavities are found as well.
bool converge(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions, double dt,
              double target, const PressureSolveControls& controls, PressureSolve& solve)
{
    const auto settle = [&] {
        const double error = residual_of_increments(grid, lists, conditions, dt, solve);
        return iterate(grid, lists, conditions, dt, error, target, controls, solve);
    };
    if (solve.cavity.cavities.empty()) return settle();
    constexpr int most_sets = 30; // then the last is taken: a cell at the limit may belong to either
    begin_cavities(lists, solve);
    for (int k = 0; k < most_sets; ++k) {
        if (!settle()) return false;
        if (!revise_cavities(lists, solve)) break;
    }
    return true;
}

} // namespace

void aggregate_pressures(const std::vector<AggregatedCell>& aggregated, PressureSolve& solve)
{
    solve.aggregated = aggregated;
    for (const AggregatedCell& cell : aggregated) solve.storage[static_cast<std::size_t>(cell.slot)] = 0.0;
    copy_from_roots(solve, solve.expected);
    copy_from_roots(solve, solve.increment);
}

void set_up_preconditioner(const BackgroundGrid& grid, const CellLists& lists,
                           const NodeConditions& conditions, double dt, PressureSolve& solve)
{
    set_diagonal(grid, lists, dt, solve);
    if (std::exchange(solve.blocks_are_due, false)) {
        set_up_blocks(grid, lists, conditions, dt, solve, solve.blocks);
        solve.iterations_when_new.reset();
    }
    scale_blocks(solve.diagonal, solve.blocks);
}

bool solve_increments(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions,
                      double dt, const PressureSolveControls& controls, PressureSolve& solve)
{
    const auto known = [&](std::size_t c) { return known_inflow(solve, c); };
    const double scale = set_right_hand_side(grid, lists, dt, known, solve);
    sum_to_roots(solve, solve.right_hand_side);
    solve.iterations = 0;
    const bool converged = converge(grid, lists, conditions, dt,
                                    controls.tolerance * controls.tolerance * scale, controls, solve);
    if (!solve.iterations_when_new) {
        solve.iterations_when_new = solve.iterations;
        solve.iterations_lost = 0;
    }
    solve.iterations_lost += std::max(0, solve.iterations - *solve.iterations_when_new);
    return converged;
}

void set_increment_forces(const BackgroundGrid& grid, const CellLists& lists,
                          const NodeConditions& conditions, PressureSolve& solve)
{
    copy_from_roots(solve, solve.increment);
    scatter_pressure(grid, lists, solve.increment, solve);
    gather_tied_forces(conditions, solve);
}

void set_changes(const CellLists& lists, PressureSolve& solve)
{
    const Scalars& increment = solve.cavity.cavities.empty() ? solve.increment : solve.cavity.water_increment;
    for_each_tile(lists, [&](const Tile& tile) {
        for_each_stencil(solve, tile, [&](const TileDivergence&, const CellStencil&, std::size_t c) {
            solve.change[c] = (increment[c] + solve.expected[c]) / acting_weight;
        });
    });
}

} // namespace quicksand
