// The change of the nodes' velocities in a step whose grains have the inertia of K besides their masses.
//
//   (R^-1 + b K) w = R^-1 w_0
//
// w_0 is the change that forces make without K, R the response of the grains to forces on the nodes over the
// step: masses, drag, dashpots, walls and the implicit pressure of the water, whatever the step has. K is the
// elastic stiffness of the skeleton (node_stiffness.hpp), b = beta dt dt_v, dt_v the time over which forces
// act. The nodes then have the mass M + b K. This is the operator-splitting method (Nakashima 1990) in
// leapfrog form: with K_t, the stiffness by which the present stress changes, it is stable at any dt where
// K_t <= 4 beta K. beta = 0.425 bears a mean stress that grows to 2.9 times what K knows of within a step,
// for the moduli of sand grow with its root; a smaller beta leaves longer steps at the same smoothing, which
// is what errors follow. The period of a motion of the frequency omega is (beta - 1/12) (omega dt)^2 / 2 too
// long, and nothing is damped. Accelerations are smoothed over sqrt(b/m K)/k, while forces, velocities and
// strains are not: rest, steady flow and constant velocities are exact; translations and small turns meet no
// force, so that momentum is.
// With c > 0 velocities meet the force - c dt K v' besides: (R^-1 + (beta + c) dt dt_v K) (v' - kept v)
// follows from forces in the same way, with kept = beta / (beta + c). Vibrations that steps do not follow
// shrink by the root of kept in each; slow motion feels the stress that it will have after c dt. The response
// without R's pressure is factorised (stiff_response.hpp); the pressure is solved for with it.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/inertia/cell_moduli.hpp"
#include "solver/inertia/node_rows.hpp"
#include "solver/inertia/node_stiffness.hpp"
#include "solver/inertia/stiff_response.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quicksand {

inline constexpr double inertia_fraction = 0.425; // beta [-]
// c where nothing moves the soil any more [-]: vibrations fall to a tenth in 22 steps; the pore pressures of
// a liquefied column that drains were those of steps twenty times shorter within 2 %, with .25 within 4 %,
// and beta = 1/2.
inline constexpr double damping_of_vibrations = 0.1;
// The same while soil settles. Local damping adds up to 0.95 of a braking force to it, and particles in cells
// that they share with soil are up to 1.2 times stiffer than K: 1.95 * 1.2 <= 4 (beta + c).
inline constexpr double damping_of_settling_solids = 0.5;

/// Places of a tied node and its master.
struct TiedPlaces {
    std::size_t tied = 0, master = 0;
};

/// The equations, and work arrays; fields are by place, zero where there is no soil.
struct InertiaSolve {
    std::vector<std::uint8_t> resists; // by material: whether its stiffness does
    NodeRows rows;
    std::vector<std::size_t> places; // of the nodes in these rows
    CellModuli cells;
    NodeStiffness stiffness;
    std::vector<TiedPlaces> tied;
    StiffResponse response;
    Vectors before;  // velocities before the step [m/s]
    Vectors change;  // w [m/s]
    Vectors product; // of a field with K
    Vectors answer;  // of the nodes to impulses [m/s]
    Vectors moving;  // impulses that move the nodes as they do, without K [N s/m]
    double resistance =
        inertia_fraction; // beta + c: the inertia forces are - (beta + c) dt K (v' - kept v) [-]
    double kept = 1.0;    // beta / (beta + c) [-]
};

/// With K of the whole skeleton in the shaking. While soil settles it takes the steps of its own waves, and K
/// is that of solids alone (solid_mixture.hpp), whose waves would ask for far shorter ones.
InertiaSolve make_inertia_solve(const Problem& problem, const NodeConditions& conditions, Stage stage);

/// Whether a node has stiffness: there is a cell beside it whose soil or solid resists.
bool is_resisted(const InertiaSolve& solve, std::size_t node);

/// Give the cells around nodes without mass no stiffness of four nodes; returns those that have three nodes.
/// `corners` are all cells and their corners without mass, in any order.
std::vector<ThreeNodeCell> take_incomplete_cells(std::vector<ThreeNodeCell> corners, CellModuli& cells);

/// Set up the stiffness from the moduli of the cells, on the nodes with is_active(node); a cell with two
/// nodes that are not has none.
template <class IsActive>
void set_up_stiffness(IsActive&& is_active, InertiaSolve& solve)
{
    std::vector<NodeSpan> spans;
    find_spans(solve.rows, is_active, spans);
    const std::size_t stride = solve.rows.stride;
    std::vector<ThreeNodeCell> corners;
    for (std::size_t node = 0; node < solve.places.size(); ++node) {
        if (is_active(node)) continue;
        for (const std::size_t corner : {0U, 1U, 2U, 3U}) {
            const std::size_t before = corner % 2 + corner / 2 * stride, place = solve.places[node];
            if (before > place || !(solve.cells.constrained[place - before] > 0.0)) continue;
            corners.push_back({place - before, corner});
        }
    }
    const std::vector<ThreeNodeCell> with_three_nodes =
        take_incomplete_cells(std::move(corners), solve.cells);
    solve.stiffness.assemble(solve.rows, solve.cells, with_three_nodes, std::move(spans));
    for (Vectors* field : {&solve.change, &solve.product, &solve.moving}) {
        field->x.assign(solve.rows.size(), 0.0);
        field->y.assign(solve.rows.size(), 0.0);
    }
}

/// product = factor K field, with that of tied nodes at their masters; the field of tied nodes becomes that
/// of their masters.
void multiply_stiffness(double factor, Vectors& field, InertiaSolve& solve);

} // namespace quicksand
