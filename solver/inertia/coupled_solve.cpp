#include "solver/inertia/coupled_solve.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// s where the rows are scaled to what their nodes answer [-].
constexpr double softness = 1e-9;
/// Of the right-hand side, after which iterating ends [-].
constexpr double tolerance = 1e-10;
constexpr int most_corrections = 10;

constexpr std::uint8_t held_bits[4] = {solid_x_fixed, solid_y_fixed, fluid_x_fixed, fluid_y_fixed};
constexpr std::uint8_t seal_bits[2] = {seal_x, seal_y};

/// The unknowns of a node's velocities from `count` on. Where a seal moves grains and water together they are
/// one; held grains of a seal hold its water.
std::array<std::int32_t, 4> unknowns_of(const CoupledNode& node, std::int32_t& count)
{
    std::array<std::int32_t, 4> result{-1, -1, -1, -1};
    for (std::size_t d = 0; d < 4; ++d) {
        const std::size_t axis = d % 2;
        const bool sealed = (node.held & seal_bits[axis]) != 0;
        if ((node.held & held_bits[d]) != 0) continue;
        if (d >= 2 && sealed) {
            result[d] = result[axis];
        } else if (node.mass(static_cast<int>(d), static_cast<int>(d)) > 0.0) {
            result[d] = count++;
        }
    }
    return result;
}

void number_unknowns(const NodeConditions& conditions, const std::vector<CoupledNode>& nodes,
                     const VelocityRows& rows, const PressureSolve& pressure, CoupledSolve& solve)
{
    solve.count = 0;
    solve.unknowns.assign(conditions.of_node.size(), {-1, -1, -1, -1});
    for (const CoupledNode& node : nodes) solve.unknowns[node.node] = unknowns_of(node, solve.count);
    for (const TiedNodes& tie : conditions.tied) solve.unknowns[tie.node] = solve.unknowns[tie.master];
    solve.of_cell.assign(pressure.storage.size(), -1);
    std::vector<std::uint8_t> follows(pressure.storage.size(), 0);
    for (const AggregatedCell& cell : pressure.aggregated) follows[static_cast<std::size_t>(cell.slot)] = 1;
    for (const TileDivergence& divergence : pressure.divergence)
        for (const CellStencil& cell : divergence.stencils)
            if (follows[static_cast<std::size_t>(cell.cell)] == 0)
                solve.of_cell[static_cast<std::size_t>(cell.cell)] = solve.count++;
    for (const AggregatedCell& cell : pressure.aggregated)
        solve.of_cell[static_cast<std::size_t>(cell.slot)] =
            solve.of_cell[static_cast<std::size_t>(cell.root)];
    solve.first_row = solve.count;
    solve.count += static_cast<std::int32_t>(rows.size());
}

/// Add to an entry of the lower half and so to the one above the diagonal; of an entry within one unknown
/// both come here.
void add(std::int32_t a, std::int32_t b, double value, CoupledSolve& solve)
{
    if (a < 0 || b < 0) return;
    solve.entries.emplace_back(std::max(a, b), std::min(a, b), value);
}

void add_masses(const std::vector<CoupledNode>& nodes, CoupledSolve& solve)
{
    for (const CoupledNode& node : nodes) {
        const std::array<std::int32_t, 4>& of = solve.unknowns[node.node];
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b)
                if (of[a] >= of[b])
                    add(of[a], of[b], node.mass(static_cast<int>(a), static_cast<int>(b)), solve);
    }
}

/// The stiffness of the nodes, that of tied ones at their masters.
void add_stiffness(double factor, const InertiaSolve& inertia, CoupledSolve& solve)
{
    const std::size_t nodes_x = inertia.rows.nodes_x;
    inertia.stiffness.for_each_node([&](std::size_t i, std::size_t place) {
        const std::array<std::int32_t, 4>& of = solve.unknowns[i];
        if (of[0] < 0 && of[1] < 0) return;
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t a = 0; a < 3; ++a) {
                const std::array<std::int32_t, 4>& other = solve.unknowns[i + b * nodes_x + a - nodes_x - 1];
                const Eigen::Matrix2d block = inertia.stiffness.block(place, a, b);
                for (int row = 0; row < 2; ++row)
                    for (int column = 0; column < 2; ++column)
                        if (of[static_cast<std::size_t>(row)] >= other[static_cast<std::size_t>(column)])
                            add(of[static_cast<std::size_t>(row)], other[static_cast<std::size_t>(column)],
                                factor * block(row, column), solve);
            }
    });
}

/// Call visit(slot, node, D) for the cells of the pressure and the nodes that they touch.
template <class Visit>
void for_each_touch(const PressureSolve& pressure, std::size_t nodes_x, Visit&& visit)
{
    for (const TileDivergence& divergence : pressure.divergence) {
        for (const CellStencil& cell : divergence.stencils) {
            auto k = static_cast<std::size_t>(cell.first);
            for (std::size_t b = 0; b < static_cast<std::size_t>(cell.height); ++b)
                for (std::size_t a = 0; a < static_cast<std::size_t>(cell.width); ++a, ++k)
                    visit(static_cast<std::size_t>(cell.cell),
                          static_cast<std::size_t>(cell.base) + b * nodes_x + a,
                          Vector2(divergence.x[k], divergence.y[k]));
        }
    }
}

/// Parts of grains and water in the flux of a node, by NodeVelocities.
NodeVelocities flux_parts(double porosity, const Vector2& D)
{
    return {(1.0 - porosity) * D.x(), (1.0 - porosity) * D.y(), porosity * D.x(), porosity * D.y()};
}

/// Storage and divergence of the cells, and their right-hand sides.
void add_cells(double dt, double velocity_dt, const std::vector<std::size_t>& number_of_node,
               const std::vector<CoupledNode>& nodes, const InertiaSolve& inertia,
               const PressureSolve& pressure, CoupledSolve& solve)
{
    for (std::size_t slot = 0; slot < solve.of_cell.size(); ++slot) {
        const std::int32_t cell = solve.of_cell[slot];
        if (cell < 0) continue;
        add(cell, cell, -velocity_dt / dt * pressure.storage[slot], solve);
        solve.right_hand_side[cell] += velocity_dt / dt * known_inflow(pressure, slot);
    }
    for_each_touch(pressure, inertia.rows.nodes_x, [&](std::size_t slot, std::size_t i, const Vector2& D) {
        if (number_of_node[i] == nodes.size()) return;
        const CoupledNode& node = nodes[number_of_node[i]];
        const NodeVelocities parts = velocity_dt * flux_parts(node.porosity, D);
        const std::int32_t cell = solve.of_cell[slot];
        for (std::size_t d = 0; d < 4; ++d)
            add(cell, solve.unknowns[i][d], -parts[static_cast<int>(d)], solve);
        solve.right_hand_side[cell] += parts.dot(node.before);
    });
}

/// The rows, and what they miss before the step.
void add_rows(const std::vector<std::size_t>& number_of_node, const std::vector<CoupledNode>& nodes,
              const VelocityRows& rows, CoupledSolve& solve)
{
    for (std::size_t row = 0; row < rows.size(); ++row)
        solve.right_hand_side[solve.first_row + static_cast<std::int32_t>(row)] = rows.value(row);
    rows.for_each_coefficient([&](std::size_t row, std::size_t node, const NodeVelocities& c) {
        const std::int32_t equation = solve.first_row + static_cast<std::int32_t>(row);
        for (std::size_t d = 0; d < 4; ++d)
            if (c[static_cast<int>(d)] != 0.0)
                add(equation, solve.unknowns[node][d], c[static_cast<int>(d)], solve);
        if (number_of_node[node] < nodes.size())
            solve.right_hand_side[equation] -= c.dot(nodes[number_of_node[node]].before);
    });
}

void add_impulses(const std::vector<CoupledNode>& nodes, CoupledSolve& solve)
{
    for (const CoupledNode& node : nodes) {
        for (std::size_t d = 0; d < 4; ++d) {
            const std::int32_t unknown = solve.unknowns[node.node][d];
            if (unknown >= 0) solve.right_hand_side[unknown] += node.impulse[static_cast<int>(d)];
        }
    }
}

/// Scale the matrix to a diagonal of ones, of minus ones for the cells. A row gets the scale of what its
/// nodes answer; one that acts on nothing has a diagonal of its own.
void scale_matrix(CoupledSolve& solve)
{
    Eigen::VectorXd diagonal = solve.matrix.diagonal().cwiseAbs();
    const std::int32_t first = solve.first_row;
    for (int column = 0; column < first; ++column)
        for (CoupledSolve::Matrix::InnerIterator entry(solve.matrix, column); entry; ++entry)
            if (entry.row() >= first && diagonal[column] > 0.0)
                diagonal[entry.row()] += entry.value() * entry.value() / diagonal[column];
    solve.scale.resize(solve.count);
    for (int k = 0; k < solve.count; ++k)
        solve.scale[k] = diagonal[k] > 0.0 ? 1.0 / std::sqrt(diagonal[k]) : 1.0;
    for (int column = 0; column < solve.count; ++column)
        for (CoupledSolve::Matrix::InnerIterator entry(solve.matrix, column); entry; ++entry)
            entry.valueRef() *= solve.scale[entry.row()] * solve.scale[column];
    for (int k = first; k < solve.count; ++k) solve.matrix.coeffRef(k, k) = -softness;
}

bool factorise(CoupledSolve& solve)
{
    const int* inner = solve.matrix.innerIndexPtr();
    const int* outer = solve.matrix.outerIndexPtr();
    std::vector<std::int32_t> pattern(inner, inner + solve.matrix.nonZeros());
    pattern.insert(pattern.end(), outer, outer + solve.matrix.outerSize() + 1);
    if (solve.factor.use_count() != 1 || pattern != solve.pattern) {
        solve.factor = std::make_shared<Eigen::SimplicialLDLT<CoupledSolve::Matrix, Eigen::Lower>>();
        solve.factor->analyzePattern(solve.matrix);
        solve.pattern = std::move(pattern);
    }
    solve.factor->factorize(solve.matrix);
    return solve.factor->info() == Eigen::Success;
}

bool iterate(CoupledSolve& solve)
{
    const Eigen::VectorXd given = solve.scale.cwiseProduct(solve.right_hand_side);
    const double target = tolerance * given.norm();
    Eigen::VectorXd& x = solve.solution;
    x = Eigen::VectorXd::Zero(solve.count);
    Eigen::VectorXd left = given;
    for (int k = 0; k < most_corrections && left.norm() > target; ++k) {
        x += solve.factor->solve(left);
        left = given - solve.matrix.selfadjointView<Eigen::Lower>() * x;
    }
    const bool found = left.norm() <= std::sqrt(tolerance) * given.norm();
    x = solve.scale.cwiseProduct(x);
    return found;
}

void set_result(const std::vector<CoupledNode>& nodes, InertiaSolve& inertia, PressureSolve& pressure,
                const CoupledSolve& solve, std::vector<NodeVelocities>& changes)
{
    for (Scalars* part : {&inertia.change.x, &inertia.change.y, &inertia.product.x, &inertia.product.y})
        part->assign(inertia.rows.size(), 0.0);
    changes.assign(nodes.size(), NodeVelocities::Zero());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        for (std::size_t d = 0; d < 4; ++d) {
            const std::int32_t unknown = solve.unknowns[nodes[k].node][d];
            if (unknown >= 0) changes[k][static_cast<int>(d)] = solve.solution[unknown];
        }
        const std::size_t place = inertia.rows.place(nodes[k].node);
        inertia.change.x[place] = changes[k][0];
        inertia.change.y[place] = changes[k][1];
    }
    for (std::size_t slot = 0; slot < solve.of_cell.size(); ++slot)
        if (solve.of_cell[slot] >= 0) pressure.increment[slot] = solve.solution[solve.of_cell[slot]];
}

} // namespace

bool solve_coupled(const NodeConditions& conditions, double dt, double velocity_dt, double stiffness_factor,
                   const std::vector<CoupledNode>& nodes, const VelocityRows& rows, InertiaSolve& inertia,
                   PressureSolve& pressure, CoupledSolve& solve, std::vector<NodeVelocities>& changes)
{
    number_unknowns(conditions, nodes, rows, pressure, solve);
    std::vector<std::size_t> number_of_node(conditions.of_node.size(), nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) number_of_node[nodes[k].node] = k;
    for (const TiedNodes& tie : conditions.tied) number_of_node[tie.node] = number_of_node[tie.master];
    solve.entries.clear();
    solve.right_hand_side = Eigen::VectorXd::Zero(solve.count);
    add_masses(nodes, solve);
    add_stiffness(stiffness_factor, inertia, solve);
    add_cells(dt, velocity_dt, number_of_node, nodes, inertia, pressure, solve);
    add_rows(number_of_node, nodes, rows, solve);
    for (std::int32_t k = solve.first_row; k < solve.count; ++k) add(k, k, 0.0, solve);
    add_impulses(nodes, solve);
    solve.matrix.resize(solve.count, solve.count);
    solve.matrix.setFromTriplets(solve.entries.begin(), solve.entries.end());
    scale_matrix(solve);
    if (!factorise(solve) || !iterate(solve)) return false;
    set_result(nodes, inertia, pressure, solve, changes);
    return true;
}

} // namespace quicksand
