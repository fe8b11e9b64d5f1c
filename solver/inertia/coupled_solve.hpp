// Velocities and pressures of a step whose inertia and pore pressure are implicit together.
//
// Where waves of the skeleton pass through the whole body within a step, its stiffness and the water must
// answer together. With w the change of the velocities u = (v_s, v_w) from u_0 before the step, dp the
// increments of the cells' pressures and m the multipliers of the rows at walls,
//   (A + b K) w        - dt_v B^T dp   + C^T m = i - A u_0
//   - dt_v B w         - (dt_v/dt) S dp        = dt_v B u_0
//     C w                                - s m = V - C u_0
// A: masses, drag and dashpots of the nodes; K: stiffness of the grains, b = beta dt dt_v; B: divergence of
// the flux (1-n) v_s + n v_w in the cells; S = n V / K_w; i: momenta and impulses of the known forces; V:
// what the rows ask for. A row yields by s m, a billionth of what its nodes would move by without it: so rows
// that nearly repeat each other, as at tips and corners, need not be told apart, and the symmetric matrix is
// quasi-definite (Vanderbei 1995), with factors L D L^T in any order. Velocities are far smaller than the i
// of each node over its mass where forces and reactions balance, and are nowhere found as a difference from
// it.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/inertia/inertia_solve.hpp"
#include "solver/water/pressure_solve.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace quicksand {

/// Work arrays of the solve.
struct CoupledSolve {
    using Matrix = Eigen::SparseMatrix<double>;

    std::vector<std::array<std::int32_t, 4>> unknowns; // of the nodes, as NodeVelocities; -1: held
    std::vector<std::int32_t> of_cell;                 // unknown of the pressure by slot; -1: no soil
    std::int32_t count = 0;                            // of all unknowns
    std::int32_t first_row = 0;                        // unknown of the first multiplier
    std::vector<Eigen::Triplet<double>> entries;       // of the lower half
    Matrix matrix;                                     // the lower half, scaled to a diagonal of +-1
    Eigen::VectorXd scale, right_hand_side, solution;
    std::shared_ptr<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>> factor; // copies of the solve share it
    std::vector<std::int32_t> pattern; // of the matrix for which the factor was ordered
};

/// A node's part in the equations.
struct CoupledNode {
    std::size_t node = 0;
    NodeInverse mass = NodeInverse::Zero();          // A [kg/m]
    NodeVelocities before = NodeVelocities::Zero();  // u_0, of the grains what is kept of it [m/s]
    NodeVelocities impulse = NodeVelocities::Zero(); // i - A u_0 [N s/m]
    std::uint8_t held = 0;                           // NodeCondition bits
    double porosity = 0.0;                           // [-]
};

/// Solve over `dt` with velocities that change over `velocity_dt`: sets inertia.change, pressure.increment
/// and `changes` w of the nodes, in their order. Returns whether a solution was found.
bool solve_coupled(const NodeConditions& conditions, double dt, double velocity_dt, double stiffness_factor,
                   const std::vector<CoupledNode>& nodes, const VelocityRows& rows, InertiaSolve& inertia,
                   PressureSolve& pressure, CoupledSolve& solve, std::vector<NodeVelocities>& changes);

} // namespace quicksand
