// The change of the nodes' velocities in a step whose grains have the inertia of K besides their masses.
//
//   (R^-1 + b K) w = R^-1 w_0
//
// w_0 is the change that forces make without K, R the response of the grains to forces on the nodes over the
// step: masses, drag, dashpots, walls and the implicit pressure of the water, whatever the step has. K is the
// elastic stiffness of the skeleton (node_stiffness.hpp), b = beta dt dt_v, dt_v the time over which forces
// act. The nodes then have the mass M + b K. This is the operator-splitting method (Nakashima 1990) in
// leapfrog form: with K_t, the stiffness by which the present stress changes, it is stable at any dt where
// K_t <= 4 beta K. beta = 1/2 bears a mean stress that grows fourfold within a step, for the moduli of sand
// grow with its root. The period of a motion of the frequency omega is (beta - 1/12) (omega dt)^2 / 2 too
// long, and nothing is damped. Accelerations are smoothed over sqrt(b/m K)/k, while forces, velocities and
// strains are not: rest, steady flow and constant velocities are exact; translations and small turns meet no
// force, so that momentum is.
//
// Solver: conjugate gradients with R as preconditioner. R^-1 of the directions follows from the residuals, so
// that R alone is applied.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/inertia/cell_moduli.hpp"
#include "solver/inertia/node_rows.hpp"
#include "solver/inertia/node_stiffness.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace quicksand {

/// Places of a tied node and its master.
struct TiedPlaces {
    std::size_t tied = 0, master = 0;
};

/// The equations, and work arrays; fields are by place, zero where there is no soil.
struct InertiaSolve {
    NodeRows rows;
    std::vector<NodeSpan> spans; // with soil
    CellModuli cells;
    NodeStiffness stiffness;
    std::vector<TiedPlaces> tied;
    Vectors change;              // w: the solution [m/s]
    Vectors residual;            // forces that w leaves, times dt_v [N s/m]
    Vectors answer;              // R residual [m/s]
    Vectors direction;           // of the conjugate gradients [m/s]
    Vectors impulse;             // R^-1 direction [N s/m]
    Vectors product;             // of the direction with b K [N s/m]
    Scalars partial;             // sums of the spans
    double scale = 0.0;          // largest first residual of the step's solves, squared in the norm of R
    std::int32_t iterations = 0; // of the last solve [-]
};

inline constexpr double inertia_fraction = 0.5; // beta [-]

struct InertiaControls {
    /// Of the largest first residual of a step in the norm of R: accelerations that are left [-].
    double tolerance = 1e-4;
    std::int32_t max_iterations = 1000; // then the solve has failed
};

/// velocity = R impulse at the nodes with soil; tied nodes are zero in both.
using NodeResponseOfStep = std::function<void(const Vectors& impulse, Vectors& velocity)>;

InertiaSolve make_inertia_solve(const BackgroundGrid& grid, const NodeConditions& conditions);

/// Set up the stiffness from the moduli of the cells, on the nodes with is_active(node); a cell with a node
/// that is not has none. Fields become zero.
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
    for (Vectors* field :
         {&solve.change, &solve.residual, &solve.answer, &solve.direction, &solve.impulse, &solve.product}) {
        field->x.assign(solve.rows.size(), 0.0);
        field->y.assign(solve.rows.size(), 0.0);
    }
}

/// product = factor K field, with that of tied nodes at their masters; the field of tied nodes becomes that
/// of their masters. Returns field . product.
double multiply_stiffness(double factor, Vectors& field, InertiaSolve& solve);

/// Improve `change`, of which `residual` is left, to the tolerance of `scale`; `factor` is b [s2]. Returns
/// whether it converged.
bool solve_change(double factor, const NodeResponseOfStep& respond, const InertiaControls& controls,
                  InertiaSolve& solve);

} // namespace quicksand
