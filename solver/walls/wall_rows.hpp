// Walls at any angle and offset to the grid: conditions on the velocities that match the pressure's force on
// the nodes.
//
// The force of a constant pressure p on node i is p a_i with the discrete boundary normal
//   a_i = sum_p V_p grad phi_ip,
// zero inside the soil, the integral of the node's function times the outward normal along its edges
// otherwise. A wall holds, for each hat psi_m along its chain (wall_chains.hpp),
//   sum_i psi_m(s_i) g_i n . v_i = sum_i psi_m(s_i) g_i n . V_i
// with g_i the part of a_i that belongs to the wall: at a corner a_i is divided among the curves that meet
// there. The multipliers of these rows make any force p a_i, so that constant pressure is at rest whatever
// the particles' shapes; rows that are not proportional to a_i leak. A sealed wall holds the flux of the
// water against the grains, n_i (v_w,i - v_s,i), in the place of v_i: constant pressure acts with n_i p a_i
// on the water. Nodes without a well filled cell follow one (cell_roots.hpp).
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/state.hpp"
#include "solver/walls/cell_roots.hpp"
#include "solver/walls/velocity_rows.hpp"
#include "solver/walls/wall_chains.hpp"
#include "solver/walls/wall_contacts.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace quicksand {

/// Work space of the rows; empty where every wall is a condition on nodes and no soil ends within a cell.
struct WallRows {
    SoilEdges edges;
    bool moves = false;            // whether any chain does
    std::vector<bool> chain_moves; // which
    bool any = false;              // whether the scene has rows at all
    bool aggregates_soil = false;  // cells that soil fills badly have roots
    /// So have those that hold little water, where soil above the water table is dry: explicit steps would be
    /// short without bound where almost no water reaches a node. Implicit pressure and drag are stable there.
    bool aggregates_water = false;
    /// Solids, or dry soil in implicit or undrained pressures, lie beside soil whose water has a pressure:
    /// cells that both share have roots, for the pressure. The strain of the whole cell would set that of
    /// little water.
    bool shares_pressures = false;
    bool divides_water = false; // wet and other particles meet: their normals differ
    bool keeps_water = false;   // undrained: the pressure follows from the change of volume
    WallContacts contacts;
    bool contacts_are_due = true;
    bool normals_are_kept = false;           // small strain: they hold for all steps
    std::vector<std::uint8_t> touched_slots; // cells whose particles may give weight to a node in contact
    std::vector<std::uint8_t> touched_nodes;
    std::vector<std::uint8_t> active_nodes; // of those in contact: whether they have soil
    Vectors normal;                         // a_i of the nodes in contact, of all soil [m]
    Vectors wet_normal;                     // of the wet particles, where there are others [m]
    CellRoots roots;
    CellRoots wet_roots; // of the wet particles alone, where the water has its own or there are solids
    VelocityRows rows;
    /// Of walls that move: by how much the velocities that they give the rows' nodes have changed since the
    /// step before [m/s].
    std::vector<NodeVelocities> changes;
    std::vector<std::size_t> chain_of_row; // of the rows before the followers'

    /// The cells that have the pressure of another.
    const std::vector<AggregatedCell>& shared_pressures() const
    {
        return aggregates_water || shares_pressures ? wet_roots.aggregated : roots.aggregated;
    }
};

void set_up_wall_rows(const Problem& problem, Stage stage, WallRows& walls);

/// Bring the chains to where they are at the state's time, with their velocities over dt, and sum up the
/// normals of the nodes in contact from the weights of the particles.
void place_wall_rows(const Problem& problem, double dt, const State& state, const NodeConditions& conditions,
                     const CellLists& lists, const std::vector<StencilStore>& stencils, WallRows& walls);

/// Set up the rows on nodes with soil: of the chains, and of the nodes that follow others; then factorise
/// them. `dt` is the time over which forces act [s].
void assemble_wall_rows(const Problem& problem, const NodeConditions& conditions, double dt,
                        const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                        WallRows& walls);
void assemble_wall_rows(const Problem& problem, const NodeConditions& conditions, double dt,
                        const std::vector<Dashpot>& dashpots, const std::vector<SinglePhaseSums>& sums,
                        WallRows& walls);

/// Give the nodes velocities that meet the rows, after the momentum balance.
void hold_at_walls(const Problem& problem, const std::vector<TwoPhaseSums>& sums, const WallRows& walls,
                   std::vector<TwoPhaseMotion>& motion);
void hold_at_walls(const WallRows& walls, std::vector<SinglePhaseMotion>& motion);

/// The same for walls at rest, wherever they move.
void rest_at_walls(const Problem& problem, const std::vector<TwoPhaseSums>& sums, const WallRows& walls,
                   std::vector<TwoPhaseMotion>& motion);
void rest_at_walls(const WallRows& walls, std::vector<SinglePhaseMotion>& motion);

/// Replace forces on the nodes by what the walls leave of them: the part that accelerates. Damping that takes
/// a part of a force then takes none of a wall's reaction. `acceleration` is that of the base [m/s2].
void leave_unbalanced_forces(const Problem& problem, double acceleration, const WallRows& walls,
                             std::vector<SinglePhaseSums>& sums);

/// Forces that the rows of chains put on rows.nodes() to hold the forces at rest; chosen(chain) tells which
/// chains.
std::vector<Vector2> resting_reactions(const Problem& problem, const WallRows& walls,
                                       const std::vector<SinglePhaseSums>& sums,
                                       const std::function<bool(const WallChain&)>& chosen);

} // namespace quicksand
