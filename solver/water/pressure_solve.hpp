// The implicit pressure of the semi-implicit step: one symmetric positive definite solve for the increments
// of the cells' pressure.
//
//   acting pressure   p + x,  x = b (dp - dt r)       at the time of all forces, the start of the step
//   rate              r + b (dp/dt - r) from r,       b = 2/3
//   mass balance      n_c V_c / K_w dp_c = - dt sum_i D_ci . flux_i
//
//   sum_c' L_cc' x_c' = - dt sum_i D_ci . flux*_i - S_c b dt r_c,         S_c = n_c V_c / (b K_w)
//   L_cc' = delta_cc' S_c + dt^2 sum_i D_ci . W_i D_c'i
//
// flux* is the flux with the old pressure. W_i = beta^T A_i^-1 beta, beta = (1-n_i, n_i), is the change of
// the flux at node i by a unit force of the pressure in a unit of time, with drag and held velocities.
//
// x is some dt^2 d2p/dt2, so that the step is of second order in time. A pressure that grows by the factor z
// in a step acts as G(z) p, G(z) = 1 + b (z-1)^2 / (z-1+b). |z| = 1 gives Im G >= 0: the pressure takes
// energy from every vibration, a part (omega dt)^3 / 2 in a radian, and sound of any speed is stable. G(-1) =
// -1, as for backward Euler (b = 1, r = 0), which takes omega dt. Solver: conjugate gradients with a
// preconditioner of blocks; the initial guess is x = 0.
//
// With a limit of tension the pressure of a cell is the larger of the limit and of the pressure that follows
// from its volume of water, and so is x, of what takes the cell there: an obstacle problem, found by the set
// of cells that have cavities (primal-dual active set: Hintermueller, Ito and Kunisch 2002). A cell of the
// set has the pressure of the limit, and its cavities take the flux.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/particles/particles.hpp"
#include "solver/walls/velocity_rows.hpp"
#include "solver/water/cell_divergence.hpp"
#include "solver/water/pore_pressure.hpp"
#include "solver/water/pressure_blocks.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace quicksand {

/// Cells with cavities, by slot of the cell lists; no entries without a limit of tension.
struct CavitySolve {
    Scalars deficit;                    // b times that at the start of the step, see pore_pressure.hpp [Pa]
    Scalars lowest_increment;           // x that takes the acting or the new pressure to the limit [Pa]
    std::vector<std::uint8_t> cavities; // whether the cell has some at the end of the step
    Scalars water_increment;            // x of pressure and deficit together, from the volume of water [Pa]
    Scalars lacking;                    // of a cell with cavities: what its water does not fill [m3/m]
};

/// flux = that of the nodes per time by forces of the pressure on them, where it is not a node's own matter.
using FluxResponse =
    std::function<void(const Scalars& force_x, const Scalars& force_y, Scalars& flux_x, Scalars& flux_y)>;

/// Unknowns and work arrays, by slot of the cell lists (only cells with soil are touched) and by node.
struct PressureSolve : PressureEquations {
    PressureBlocks blocks;
    bool blocks_are_due = true;                      // to be set up anew in the next solve
    double dt_of_blocks = 0.0;                       // for which they were set up [s]
    std::optional<std::int32_t> iterations_when_new; // of the first solve with the blocks [-]
    std::int32_t iterations_lost = 0;                // of all since, beyond those [-]
    const VelocityRows* rows = nullptr;              // of walls and followers, none without
    FluxResponse stiff_response;                 // in the place of compliance and rows, none without inertia
    std::vector<Vector2> row_forces, row_fluxes; // at the nodes of the rows
    Scalars stiffness;        // what the preconditioner answers besides, with the former; else empty [Pa/m2]
    Scalars expected;         // b dt r [Pa]
    Scalars increment;        // x: the guess, then the solution [Pa]
    Scalars change;           // dp, of pressure and deficit together with a limit [Pa]
    Scalars flux_x, flux_y;   // of the nodes, flux* at first [m/s]
    Scalars force_x, force_y; // of the increments on the nodes, zero before and after a solve [N/m]
    Scalars growth;           // of the cells by turns in the step; empty: none [m3/m]
    Scalars right_hand_side;  // [m3/m]
    Scalars residual;         // of the equations [m3/m]
    Scalars answer;           // of the preconditioner to the residual [Pa]
    Scalars direction, product; // of the conjugate gradients, and L direction [Pa, m3/m]
    Scalars partial;            // sums of the tiles [of what is summed]
    CavitySolve cavity;
    std::int32_t iterations = 0; // of the last solve [-]
};

struct PressureSolveControls {
    /// Residual / right-hand side, both weighted by the diagonal. The time step's own error is some omega dt,
    /// a few per mille; 1e-3 changes pressures by 1e-5 of their range against 1e-6, at a third of the
    /// iterations [-].
    double tolerance = 1e-3;
    std::int32_t max_iterations = 500; // then the solve has failed
};

/// What takes up water in a cell whatever the increments: the pressure's rate, and turns of the soil [m3/m].
inline double known_inflow(const PressureSolve& solve, std::size_t c)
{
    return solve.storage[c] * solve.expected[c] + (solve.growth.empty() ? 0.0 : solve.growth[c]);
}

PressureSolve make_pressure_solve(std::size_t tiles, std::size_t cells, std::size_t nodes);

/// Give the solve a limit of tension.
void add_cavities(PressureSolve& solve);

/// Request new blocks if the present ones belong to another time step (dt^2 weights the nodes' response
/// against storage) or are out of date for other reasons: walls touch other nodes, soil has moved. First call
/// in a step.
void choose_blocks(double dt, PressureSolve& solve);

/// Set the response of the nodes of rows to the pressure, with the rows. After the compliances of the nodes
/// have been set.
void set_row_response(const Scalars& porosities, VelocityRows& rows, PressureSolve& solve);

/// Let badly filled cells have the pressure of their roots. After storage and increments of the roots have
/// been set.
void aggregate_pressures(const std::vector<AggregatedCell>& aggregated, PressureSolve& solve);

/// Set up the diagonal, and the blocks where they are due. After all else that the equations consist of.
void set_up_preconditioner(const BackgroundGrid& grid, const CellLists& lists,
                           const NodeConditions& conditions, double dt, PressureSolve& solve);

/// Solve for `increment`, from its present value as guess, with `flux_x, flux_y` = flux*; with a limit of
/// tension for `cavity` as well. Returns whether it converged.
bool solve_increments(const BackgroundGrid& grid, const CellLists& lists, const NodeConditions& conditions,
                      double dt, const PressureSolveControls& controls, PressureSolve& solve);

/// Set the forces to those of the increments; masters of tied nodes have theirs, too.
void set_increment_forces(const BackgroundGrid& grid, const CellLists& lists,
                          const NodeConditions& conditions, PressureSolve& solve);

/// Set the changes of the cells' pressure from the increments.
void set_changes(const CellLists& lists, PressureSolve& solve);

} // namespace quicksand
