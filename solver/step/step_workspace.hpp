// What every step needs, whatever moves in it: where the particles are, their weights, the walls.
#pragma once

#include "solver/base/phase_timers.hpp"
#include "solver/base/threads.hpp"
#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/inertia/inertia_solve.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/measure/balances.hpp"
#include "solver/measure/node_works.hpp"
#include "solver/motion/particle_to_grid.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/walls/wall_rows.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace quicksand {

/// Memory of the steps; nothing of it has to survive a checkpoint.
struct StepWorkspace {
    CellLists lists;
    CellLists wet_lists;                                    // the wet particles alone, where there are others
    bool partly_wet = false;                                // see is_partly_wet()
    AggregatedLists aggregated_lists, aggregated_wet_lists; // where soil ends within cells
    std::optional<AggregatedLists> kept_lists;              // see lists_of_kept_volume()
    NodeConditions conditions;
    std::vector<std::uint8_t> drawn_conditions; // of the nodes by curves alone; none without solids in water
    WallRows walls;
    std::vector<StencilStore> stencils;      // per tile
    bool stencils_are_kept = false;          // small strain: they hold for all steps
    CellStrain cell_strain;                  // that stresses follow
    ParticlePlaces places;                   // of the particles that carry boundaries
    std::vector<Dashpot> dashpots;           // of viscous boundaries
    Vectors grid_velocity;                   // sum phi v_i of the grains [m/s]
    std::optional<InertiaSolve> inertia;     // none: nodes have their masses alone
    std::vector<std::uint8_t> wall_kinds;    // of the nodes for the balances, without dashpots
    std::vector<std::uint8_t> balance_nodes; // with the dashpots of the step, see balances.hpp
    std::optional<double> work_of_nodes;     // the skeleton's in the step, where it counts otherwise [J/m]
    double null_space_time = 0.0;            // tau of the velocity filter, see grid_to_particle.hpp [s]
    std::int64_t limited_domains = 0;        // domains scaled down in the last step [-]
    PhaseTimers timers;

    /// The lists by which cells have one change of volume: badly filled cells with their roots.
    const CellLists& volume_lists() const { return walls.aggregates_soil ? aggregated_lists.lists : lists; }

    /// The same of the particles that have a pore pressure.
    const CellLists& lists_with_pressure() const
    {
        if (!partly_wet) return volume_lists();
        return walls.any ? aggregated_wet_lists.lists : wet_lists;
    }

    /// The lists by whose change of volume water that is kept in its pores has a pressure: those with a
    /// pressure; while soil settles without the cells that the water has but in part, with dry soil or a
    /// solid. Such a cell has one strain, which its wet part would not have, and takes the pressure of its
    /// root. (Its pressure would do work that the root's strain does not know: vibrations grew in shaking.)
    const CellLists& lists_of_kept_volume() const
    {
        return kept_lists ? kept_lists->lists : lists_with_pressure();
    }

    const StencilStore& stencils_of(const Tile& tile) const
    {
        return stencils[static_cast<std::size_t>(tile.number)];
    }
};

void set_up_workspace(const Problem& problem, StepWorkspace& work, Stage stage = Stage::shaking);

/// Bring walls and dashpots up to the state, from the weights of the particles.
void place_boundaries(const Problem& problem, double dt, const State& state, StepWorkspace& work);

/// Bring the cell lists up to date, and the arrays of a step to the particles' number. In small strain lists
/// and weights are found once, on the reference shape. Throws NumericalError.
void locate_particles(const Problem& problem, double dt, State& state, StepWorkspace& work);

/// Set up the rows of the walls from the nodes' sums, with tied nodes gathered; `velocity_dt` is the time
/// over which forces act [s].
template <class Sums>
void assemble_walls(const Problem& problem, double velocity_dt, const std::vector<Sums>& sums,
                    StepWorkspace& work)
{
    if (!work.walls.any) return;
    assemble_wall_rows(problem, work.conditions, velocity_dt, work.dashpots, sums, work.walls);
    for (const std::size_t node : work.walls.rows.nodes()) count_reaction(node, work.balance_nodes);
}

/// Sum up the moduli of the cells that resist accelerations, from the weights of the particles.
void sum_moduli(const Problem& problem, double dt, const Particles& particles, StepWorkspace& work);

/// How the forces of a step work: where vibrations are damped and not followed, on the way of the particles.
inline Working working_of(double dt, double velocity_dt, const StepWorkspace& work)
{
    if (!work.inertia || work.inertia->kept == 1.0) return {};
    return {WorkingVelocity::last, dt / velocity_dt};
}

/// Update the stresses after the particles have moved, and the skeleton's work where it is that of stresses
/// before and after the step.
void update_stresses(const Problem& problem, double dt, StepWorkspace& work, State& state);

/// The force that resists accelerations was not found.
[[noreturn]] void fail_to_resist(double dt, const State& state);

/// Clear the sums of all nodes.
template <class Sums>
void set_to_zero(std::vector<Sums>& sums)
{
    const auto at = [&](std::size_t i) { return sums.begin() + static_cast<std::ptrdiff_t>(i); };
    for_each_chunk(sums.size(),
                   [&](std::size_t first, std::size_t last) { std::fill(at(first), at(last), Sums{}); });
}

/// Call scatter_tile(tile) for every tile, tiles of one colour at the same time, with the weights of its
/// particles in work.stencils.
template <class ScatterTile>
void for_each_weighted_tile(const Problem& problem, const Particles& particles, StepWorkspace& work,
                            ScatterTile&& scatter_tile)
{
    if (work.stencils_are_kept) {
        for_each_tile_by_colour(work.lists, scatter_tile);
        return;
    }
    std::atomic<std::int64_t> limited = 0;
    for_each_tile_by_colour(work.lists, [&](const Tile& tile) {
        // a tile's weights are used while they are still in the cache
        limited += evaluate_weights(problem, particles, work.lists, tile,
                                    work.stencils[static_cast<std::size_t>(tile.number)]);
        scatter_tile(tile);
    });
    work.limited_domains = limited;
}

} // namespace quicksand
