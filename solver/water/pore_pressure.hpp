// The mass balance of the water, cell by cell.
//
// The pressure has one increment per cell, not per particle; this prevents volumetric locking and pressure
// oscillations. The mean of a cell changes by
//   dp = - dt K_w  sum V_p div[(1-n) v_s + n v_w] / sum n_p V_p
// and, since the excess pressure refers to a static pressure that decreases with height, below the water
// level also by dt rho_w g v_y (not in small strain, where heights stay). Within the cell the pressure is a
// plane through the mean with the gradient of the neighbours' means, both of the excess pressure with
// rho_w g (y - level) besides above the water level: it has no kink there. It is of second order at the
// particles, where the mean alone would be of first order; in a filled cell it exerts no force on the volume
// mode of the cell, so that the means keep the balance of energy with the velocities.
//
// With cavitation the absolute pressure (atmosphere, static and excess pressure together) does not fall below
// a limit. The part of the increment below the limit is stored as a deficit, the volume of cavities; they
// must close before the pressure rises again, so that the volume of water is conserved.
#pragma once

#include "solver/particles/background_grid.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/water/cell_means.hpp"

namespace quicksand {

/// b of the acting pressure, see pressure_solve.hpp [-].
inline constexpr double acting_weight = 2.0 / 3.0;

/// Slopes within cells are forces that the balance of the means does not know. Where water hardly yields the
/// means answer them at once, with - a times the pressure whose slopes act; a may be complex in cells that an
/// outline cuts. With a part m of the new pressure and 1-m of the one that has acted, this is stable for
/// |a| < 1 / (1+2m). Random motion in turned columns grows with m = 1 and, in one of a hundred, with m = 1/2;
/// the smaller m, the later the slopes and the more energy a step makes with them [-].
inline constexpr double new_part_of_slopes = 0.4;

/// The same in cells with which badly filled ones are aggregated, where slopes act over a greater length: in
/// the tip of a wedge of 30 degrees random motion grows with 0.2 and, of water that hardly flows, with 0; it
/// decays with -0.2 [-].
inline constexpr double new_part_of_long_slopes = -0.5;

/// What a semi-implicit step has solved for, by slot of the cell lists: the mean p of a cell acted on the
/// nodes with p + increment.
struct SolvedPressure {
    const Scalars& expected;     // b dt r [Pa]
    const Scalars& increment;    // b (dp - dt r) [Pa]
    const Scalars& change;       // dp, of pressure and deficit together with a limit of tension [Pa]
    double following_part = 1.0; // of b, with which r follows dp/dt [-]
};

/// The part of b with which the rates of the pressures follow a step, see THEORY.md [-]. Over a short step
/// after a long one dp/dt is mostly the noise of the long one's dp: the next long step would act with dt r of
/// it, many times as large.
double following_part(double dt, double last_step);

/// dt det L: what the volume of a particle grows by in a step beyond tr L, over dt and the volume; det(I + dt
/// L) = 1 + dt (tr L + dt det L). In a turn of the rate w it is dt w^2, against tr L = - dt w^2 [1/s].
inline double growth_of_turn(double dt, const Gradients& L, std::size_t p)
{
    return dt * (L.xx[p] * L.yy[p] - L.xy[p] * L.yx[p]);
}

/// The lists of the wet particles alone: only these have a pore pressure.
void select_wet(const Problem& problem, const Particles& particles, const CellLists& all, CellLists& wet);

/// Volumes of the wet particles, 0 for the others [m3/m].
void set_wet_volumes(const Problem& problem, const Particles& particles, Scalars& volumes);

/// The water that unsaturated soil holds moves with its grains.
void carry_moisture(const Problem& problem, Particles& particles);

CellMeans make_cell_means(const Problem& problem);

/// dp of a tile's cells in an explicit step, from the divergence of the flux at the particles.
void explicit_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                         const Particles& particles, const Scalars& flux_divergence, Scalars& increment);

/// The same where grains and water move together: the flux is their velocity.
void undrained_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                          const Particles& particles, Scalars& increment);

/// For the semi-implicit step: n V / (b K_w) and b dt r of a tile's cells.
void prepare_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                        const Particles& particles, Scalars& storage, Scalars& expected);

/// Sum over a tile's cells of dt V growth_of_turn, from the affine velocities [m3/m].
void sum_growth_of_turns(double dt, const CellLists& lists, const Tile& tile, const Particles& particles,
                         Scalars& growth);

/// For the semi-implicit step with a limit of tension: b times the deficit of a tile's cells, and the
/// least increment: neither the pressure after the step nor the acting one falls below the limit [Pa].
void prepare_cavities(const Problem& problem, const CellLists& lists, const Tile& tile,
                      const Particles& particles, const Scalars& expected, Scalars& deficit,
                      Scalars& lowest_increment);

/// Advance the pressure of a tile's cells by the increments and by what their rise adds, and take the means.
void apply_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                      const Scalars& increment, Particles& particles, CellMeans& means);

/// Set the unfelt change dp - x of a tile's cells, and advance the rate r, after the means.
void follow_solved_pressure(double dt, const CellLists& lists, const Tile& tile, const SolvedPressure& solved,
                            Particles& particles, CellMeans& means);

/// Give the particles of a tile a plane through their cell's mean, with the slope of the means by least
/// squares to the up to eight neighbours that hold soil.
void reconstruct_pore_pressure(const Problem& problem, const CellLists& lists, const Tile& tile,
                               const CellMeans& means, Particles& particles);

/// The same after a semi-implicit step, with the slope of p - (1 - m) (dp - x). All cells of a slope count
/// with the m of the cell in the middle: pressures at unlike times would have slopes in uniform changes. A
/// cell that shares its pressure with the few wet particles below a water table in the cell above takes its
/// slope over in the time in which pressures even out over a cell: at once, vibrations grow with any m.
void reconstruct_solved_pressure(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                                 const CellMeans& means, Particles& particles);

/// Advance the pressure of all cells; set_increments(tile) sets the increments of a tile.
template <class SetIncrements>
void advance_pore_pressure(const Problem& problem, double dt, const CellLists& lists,
                           const Scalars& increment, Particles& particles, CellMeans& means,
                           SetIncrements&& set_increments)
{
    for_each_tile(lists, [&](const Tile& tile) {
        set_increments(tile);
        apply_increments(problem, dt, lists, tile, increment, particles, means);
    });
    for_each_tile(
        lists, [&](const Tile& tile) { reconstruct_pore_pressure(problem, lists, tile, means, particles); });
}

/// The same after a semi-implicit step.
inline void advance_solved_pressure(const Problem& problem, double dt, const CellLists& lists,
                                    const SolvedPressure& solved, Particles& particles, CellMeans& means)
{
    for_each_tile(lists, [&](const Tile& tile) {
        apply_increments(problem, dt, lists, tile, solved.change, particles, means);
        follow_solved_pressure(dt, lists, tile, solved, particles, means);
    });
    for_each_tile(lists, [&](const Tile& tile) {
        reconstruct_solved_pressure(problem, dt, lists, tile, means, particles);
    });
}

} // namespace quicksand
