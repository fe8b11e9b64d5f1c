// What a run changes: time, step count and the particles. A checkpoint of it resumes to the same bits.
#pragma once

#include "solver/base/stage.hpp"
#include "solver/particles/particles.hpp"

#include <cstdint>
#include <optional>

namespace quicksand {

/// What the steps have exchanged since the ledger was opened; ledger.hpp says how it is kept. Energies and
/// works are of both phases and per metre [J/m].
struct Ledger {
    double kinetic_change = 0.0;     // of the nodes' kinetic energy in their momentum balance
    double skeleton_work = 0.0;      // of the effective stress on the strain of the skeleton
    double late_pressure_work = 0.0; // of the pore pressure in the half step by which it is ahead
    double drag_dissipation = 0.0;   // of the drag between water and grains
    double gravity_work = 0.0;       // of the weight, buoyant below water
    double base_work = 0.0;          // of the base's acceleration, a force in the moving frame
    double boundary_work = 0.0;      // of loads, heads, moving walls and viscous boundaries
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

/// Call `visit(name, value)` for every number of a ledger, in a fixed order.
template <class AnyLedger, class Visitor>
void for_each_number(AnyLedger& ledger, Visitor&& visit)
{
    visit("ledger_kinetic_change", ledger.kinetic_change);
    visit("ledger_skeleton_work", ledger.skeleton_work);
    visit("ledger_late_pressure_work", ledger.late_pressure_work);
    visit("ledger_drag_dissipation", ledger.drag_dissipation);
    visit("ledger_gravity_work", ledger.gravity_work);
    visit("ledger_base_work", ledger.base_work);
    visit("ledger_boundary_work", ledger.boundary_work);
    visit("ledger_wall_loss", ledger.wall_loss);
    visit("ledger_impulse_x", ledger.impulse_x);
    visit("ledger_impulse_y", ledger.impulse_y);
    visit("ledger_exchange_x", ledger.exchange_x);
    visit("ledger_exchange_y", ledger.exchange_y);
    visit("ledger_outflow", ledger.outflow);
    visit("ledger_opening_kinetic_energy", ledger.opening_kinetic_energy);
    visit("ledger_opening_storage_energy", ledger.opening_storage_energy);
    visit("ledger_opening_momentum_x", ledger.opening_momentum_x);
    visit("ledger_opening_momentum_y", ledger.opening_momentum_y);
    visit("ledger_opening_water_content", ledger.opening_water_content);
}

struct State {
    Stage stage = Stage::shaking;
    double time = 0.0;      // t since the start of shaking [s]
    std::int64_t step = 0;  // steps taken in this stage [-]
    double last_step = 0.0; // length of the step before, 0 at the start of a stage [s]
    Particles particles;
    Vectors reactions;            // forces held at viscous boundaries, piece by piece; none without [N/m]
    std::optional<Ledger> ledger; // none: nobody asks for balances, and the steps enter nothing
};

/// What velocities gain acceleration for in a step of length dt: they stand in the middle of the steps, so
/// that it is half of both steps; those given at the start come to the middle of the first step. Then the
/// scheme is second order in time with steps of any lengths [s].
inline double kick_time(const State& state, double dt)
{
    return state.last_step > 0.0 ? 0.5 * (state.last_step + dt) : 0.5 * dt;
}

} // namespace quicksand
