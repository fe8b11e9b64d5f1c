// What a run changes: time, step count and the particles. A checkpoint of it resumes to the same bits.
#pragma once

#include "solver/base/stage.hpp"
#include "solver/particles/particles.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace quicksand {

/// Terms of the balances, added up since open_balances(); see balances.hpp. Energies and
/// works are of both phases and per metre [J/m].
struct BalanceTerms {
    double kinetic_change = 0.0;     // of the nodes' kinetic energy in their momentum balance
    double skeleton_work = 0.0;      // of the effective stress on the strain of the skeleton
    double late_pressure_work = 0.0; // of the pore pressure in the half step by which it is ahead
    double inertia_work = 0.0;       // of implicit steps, see balances.hpp
    double drag_dissipation = 0.0;   // of the drag between water and grains
    double gravity_work = 0.0;       // of the weight, buoyant below water
    double base_work = 0.0;          // of the base's acceleration, a force in the moving frame
    double boundary_work = 0.0;      // of loads, heads, moving walls, viscous and free-field sides
    double wall_loss = 0.0;          // kinetic energy that walls took out of the nodes they stop
    double impulse_x = 0.0;          // of weight, base and boundaries [N s/m]
    double impulse_y = 0.0;
    double exchange_x = 0.0; // momentum that came with changes of the particles' water content [N s/m]
    double exchange_y = 0.0;
    double outflow = 0.0; // water that left the soil [m3/m]

    double opening_kinetic_energy = 0.0;
    double opening_storage_energy = 0.0; // of the pore water
    double opening_momentum_x = 0.0;     // [N s/m]
    double opening_momentum_y = 0.0;
    double opening_water_content = 0.0; // [m3/m]
};

/// Call `visit(name, value)` for every number of the terms, in a fixed order.
template <class AnyTerms, class Visitor>
void for_each_number(AnyTerms& terms, Visitor&& visit)
{
    visit("balance_kinetic_change", terms.kinetic_change);
    visit("balance_skeleton_work", terms.skeleton_work);
    visit("balance_late_pressure_work", terms.late_pressure_work);
    visit("balance_inertia_work", terms.inertia_work);
    visit("balance_drag_dissipation", terms.drag_dissipation);
    visit("balance_gravity_work", terms.gravity_work);
    visit("balance_base_work", terms.base_work);
    visit("balance_boundary_work", terms.boundary_work);
    visit("balance_wall_loss", terms.wall_loss);
    visit("balance_impulse_x", terms.impulse_x);
    visit("balance_impulse_y", terms.impulse_y);
    visit("balance_exchange_x", terms.exchange_x);
    visit("balance_exchange_y", terms.exchange_y);
    visit("balance_outflow", terms.outflow);
    visit("balance_opening_kinetic_energy", terms.opening_kinetic_energy);
    visit("balance_opening_storage_energy", terms.opening_storage_energy);
    visit("balance_opening_momentum_x", terms.opening_momentum_x);
    visit("balance_opening_momentum_y", terms.opening_momentum_y);
    visit("balance_opening_water_content", terms.opening_water_content);
}

/// What the ground beyond a free-field side does in a step, by rows of nodes of the grid. Found anew from its
/// column in every step.
struct FreeFieldRows {
    Vectors force;    // of the effective stress across a vertical section, on the soil left of it [N/m]
    Scalars pressure; // the same of the excess pore pressure, against x [N/m]
    Scalars height;   // of the part of the section that a row stands for [m]
    Vectors velocity; // of the grains, mean of the values before and after the step [m/s]
};

struct FreeFieldState;

struct State {
    Stage stage = Stage::shaking;
    double time = 0.0;              // t since the start of shaking [s]
    std::int64_t step = 0;          // steps taken in this stage [-]
    std::int64_t stages_before = 0; // of a scene, which brought the soil here [-]
    double last_step = 0.0;         // length of the step before, 0 at the start of a stage [s]
    /// The same as it was chosen, before it was shortened for output; 0: not chosen by the run [s].
    double whole_step = 0.0;
    /// Part of the closed forms' step that the vibration of the nodes leaves (vibration/step_bound.hpp) [-].
    double step_scale = 1.0;
    /// Of an implicit step over that of one that waves limit (step/implicit_cost.hpp); 0: not counted yet
    /// [-].
    double implicit_cost = 0.0;
    std::int64_t step_halvings = 0; // of this step, by the watchdog (run/watchdog.hpp) [-]
    std::int64_t times_halved = 0;  // by the watchdog since the shaking began [-]
    /// Steps before this one are explicit in a semi-implicit run (run/watchdog.hpp) [-].
    std::int64_t explicit_end = 0;
    Particles particles;
    Vectors reactions; // forces held at viscous boundaries, piece by piece; none without [N/m]
    std::optional<BalanceTerms> balance_terms; // none: a run without balances
    std::vector<FreeFieldState> free_fields;   // in the order of Problem::free_fields
};

/// The ground beyond a free-field side: the state of its column, and what it does to the side.
struct FreeFieldState {
    State column;
    FreeFieldRows rows;
};

/// dt_v = (dt_last + dt) / 2, the time over which accelerations act on velocities in a step of length dt [s].
/// Velocities belong to the middle of the steps (leapfrog), which makes the scheme second order in time with
/// steps of any lengths. In the first step of a stage dt_v = dt / 2: it moves the initial velocities to the
/// middle of the step.
inline double velocity_interval(const State& state, double dt)
{
    return state.last_step > 0.0 ? 0.5 * (state.last_step + dt) : 0.5 * dt;
}

/// Part of a step that the watchdog's halvings leave [-].
inline double part_after_halvings(const State& state)
{
    return std::ldexp(1.0, -static_cast<int>(state.step_halvings));
}

} // namespace quicksand
