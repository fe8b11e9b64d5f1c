// The change of the nodes' velocities in a step whose grains have the inertia A + b K.
//
//   (A + b K) w = A w_0
//
// w_0 is the change that forces make of the masses alone, A the matrix of a node: mass of the grains, the
// drag of its water, dashpots. K is the elastic stiffness of the skeleton (node_stiffness.hpp). It filters
// accelerations, (1 - l^2 laplacian)^-1 with l = sqrt(b K / (A k^2)), and leaves forces, velocities and
// strains alone. Held nodes do not move; nodes of rows (velocity_rows.hpp) have w in the rows' null space.
// The water of a node takes part: where no row holds it, it follows the grains by the drag, and A is what is
// left for the grains; at nodes of rows its velocity is an unknown of its own. Solver: conjugate gradients
// with A^-1, which meets the conditions, as preconditioner.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/inertia/cell_moduli.hpp"
#include "solver/inertia/node_rows.hpp"
#include "solver/inertia/node_stiffness.hpp"
#include "solver/walls/velocity_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// Symmetric tensors, by place.
struct PlaceTensors {
    Scalars xx, xy, yy;

    void assign(std::size_t count)
    {
        for (Scalars* part : {&xx, &xy, &yy}) part->assign(count, 0.0);
    }
    Eigen::Matrix2d at(std::size_t i) const
    {
        return (Eigen::Matrix2d() << xx[i], xy[i], xy[i], yy[i]).finished();
    }
    void set(std::size_t i, const Eigen::Matrix2d& tensor)
    {
        xx[i] = tensor(0, 0), xy[i] = tensor(0, 1), yy[i] = tensor(1, 1);
    }
};

/// A node of rows: grains and water in the order of NodeVelocities.
struct RowNode {
    std::size_t place = 0;
    NodeInverse mass = NodeInverse::Zero();                        // A [kg/m]
    NodeVelocities wanted = NodeVelocities::Zero();                // w_0 [m/s]
    Vector2 change = Vector2::Zero(), direction = Vector2::Zero(); // of the water [m/s]
    Vector2 residual = Vector2::Zero(), product = Vector2::Zero(); // of the water [N s/m]
};

/// Places of a tied node and its master.
struct TiedPlaces {
    std::size_t tied = 0, master = 0;
};

/// The equations, and work arrays; fields are zero at places without soil.
struct InertiaSolve {
    NodeRows rows;
    std::vector<NodeSpan> spans; // with soil
    CellModuli cells;
    NodeStiffness stiffness;
    PlaceTensors mass, response; // A and A^-1 of the grains; zero at nodes of rows [kg/m, m/kg]
    Vectors wanted;              // w_0 of the grains [m/s]
    std::vector<TiedPlaces> tied;
    const VelocityRows* held = nullptr; // none: no rows
    std::vector<RowNode> row_nodes;     // in the order of held->nodes()
    std::vector<NodeVelocities> at_rows;
    Vectors change;                      // w of the grains: the solution [m/s]
    Vectors residual, answer, direction; // of the conjugate gradients
    Vectors product;                     // of the direction with the matrix
    Scalars partial;                     // sums of the spans
    std::int32_t iterations = 0;         // of the last solve [-]
};

struct InertiaControls {
    /// Residual over right-hand side, both in the norm of A^-1: accelerations that are left [-].
    double tolerance = 1e-5;
    std::int32_t max_iterations = 1000; // then the solve has failed
};

InertiaSolve make_inertia_solve(const BackgroundGrid& grid, const NodeConditions& conditions);

/// Set up the stiffness from the moduli of the cells, on the nodes with is_active(node); a cell with a node
/// that is not has none.
template <class IsActive>
void set_up_stiffness(IsActive&& is_active, InertiaSolve& solve)
{
    find_spans(solve.rows, is_active, solve.spans);
    const std::size_t stride = solve.rows.stride;
    for (std::size_t node = 0; node < solve.rows.nodes_x * solve.rows.nodes_y; ++node) {
        if (is_active(node)) continue;
        const std::size_t place = solve.rows.place(node);
        for (const std::size_t before : {std::size_t{0}, std::size_t{1}, stride, stride + 1}) {
            if (before > place) continue;
            solve.cells.constrained[place - before] = solve.cells.shear[place - before] = 0.0;
        }
    }
    solve.stiffness.assemble(solve.rows, solve.cells, solve.spans);
}

/// Solve for `change`; `factor` is b [s2]. Returns whether it converged.
bool solve_change(double factor, const InertiaControls& controls, InertiaSolve& solve);

/// product = factor K change, with that of tied nodes at their masters.
void multiply_change(double factor, InertiaSolve& solve);

} // namespace quicksand
