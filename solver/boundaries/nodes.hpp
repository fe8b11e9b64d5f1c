// What the nodes of the background grid carry within a step. Nothing of it outlives the step.
#pragma once

namespace quicksand {

/// Sums scattered from the particles of a saturated body, three groups of four, each added to as one; and the
/// drag that follows from them: its part on the velocities at the end of the step along its own two axes
/// (layer_axes.hpp), and the force that is known before the step, see centre_drag.
struct alignas(32) TwoPhaseSums {
    double mass_solid;                         // m_s [kg/m]
    double mass_fluid;                         // m_w [kg/m]
    double volume;                             // sum phi V of the saturated soil [m3/m]
    double drag;                               // C = sum phi V n^2 rho_w g_k / k [N s/m2]
    double momentum_solid_x, momentum_solid_y; // [N s/m]
    double momentum_fluid_x, momentum_fluid_y; // [N s/m]
    double stress_force_x, stress_force_y;     // - sum V sigma' grad phi [N/m]
    double pressure_force_x, pressure_force_y; // sum V p grad phi, of the whole mixture [N/m]
    double drag_1, drag_2;                     // see layered_drag.hpp; then their implicit parts [N s/m2]
    double layer_x, layer_y;                   // axis of drag_1; that of drag_2 is turned to the left [-]
    double drag_force_x, drag_force_y;         // of the velocities before the step, on the grains [N/m]
    double inertia_force_x, inertia_force_y;   // on the grains, see inertia_solve.hpp [N/m]

    bool active() const { return mass_solid > 0.0; }
};

/// Velocities at the end of the step and their change in it: the flux and v_s, v_s and v_w, and the
/// changes are each read as four.
struct TwoPhaseMotion {
    double flux_x = 0.0, flux_y = 0.0;                 // (1-n) v_s + n v_w [m/s]
    double solid_x = 0.0, solid_y = 0.0;               // v_s [m/s]
    double fluid_x = 0.0, fluid_y = 0.0;               // v_w [m/s]
    double solid_change_x = 0.0, solid_change_y = 0.0; // v_s - momentum_solid / m_s [m/s]
    double fluid_change_x = 0.0, fluid_change_y = 0.0; // v_w - momentum_fluid / m_w [m/s]
};

/// Outer forces at a node that the sums hold among those of stress and pressure, kept for the balances.
struct OuterForce {
    double load_x, load_y;   // of loads and held reactions, within the force of the stress [N/m]
    double water_x, water_y; // of water beyond a curve, within the force of the pressure [N/m]
    double risen_weight;     // of water above its level, downward, within the force of the pressure [N/m]
};

/// Sums scattered from the particles of a body that moves as one phase; the first four are added to as one.
struct alignas(64) SinglePhaseSums {
    double mass;                             // inertia [kg/m]
    double weight;                           // mass the gravity acts on [kg/m]
    double momentum_x, momentum_y;           // [N s/m]
    double stress_force_x, stress_force_y;   // - sum V sigma' grad phi [N/m]
    double inertia_force_x, inertia_force_y; // see inertia_solve.hpp [N/m]

    bool active() const { return mass > 0.0; }
};

/// Velocities at the end of the step and their change in it, read as one.
struct SinglePhaseMotion {
    double x, y;               // v [m/s]
    double change_x, change_y; // v - momentum / mass [m/s]
};

/// Mass that moves with the velocity of the grains [kg/m].
inline double mass_of(const TwoPhaseSums& node)
{
    return node.mass_solid;
}
inline double mass_of(const SinglePhaseSums& node)
{
    return node.mass;
}

} // namespace quicksand
