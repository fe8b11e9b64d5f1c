// Balances of energy, momentum and water: works, dissipation by drag, impulses and outflow, added up over the
// steps.
//
// In an explicit step the nodal balance holds exactly: with v the mean of the velocities before and after,
// m (v1^2 - v0^2) / 2 = dt f . v for the sum of all forces f. The work of a force is therefore the nodal
// force times the mean velocity. It belongs to the time of the velocities, half a step before that of the
// stresses. The difference between the kinetic energy of the nodes and that of the particles is lost in the
// transfers and at the walls; this numerical dissipation is a term of its own. (Works on nodes:
// node_works.hpp.)
//
// In a long step, whose stiffness and pressure are solved together, forces work with the velocities after it
// where nothing moves the soil and vibrations are damped.
// Those before it come from the particles and are smoother: over such a step the difference, times forces
// that balance each other, would be energy made or lost, while water flows steadily and nothing moves. They
// work for as long as particles move, which is longer than forces act on velocities where steps grow.
//
// In implicit steps, within which stresses change much, the skeleton's work is that of the mean of the
// stresses before and after the step on the strain of the particles. What the nodes' forces have done besides
// is work of the implicit steps: against the stiffness that resists accelerations, and what their damping
// takes.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Start the balances at the present state; all terms are counted from here.
void open_balances(const Problem& problem, State& state);

/// sum V sigma' : L [W/m]
double stress_power(const Particles& particles);

/// Let the skeleton's work in a step be `work` and not that of the nodes [J/m].
void enter_skeleton_work(double work, double work_of_nodes, BalanceTerms& terms);

/// Add the water that left the soil in a step: dt sum V (div[(1-n) v_s + n v_w] - div v_s). Before the
/// particles move.
void enter_outflow(const Problem& problem, double dt, const Particles& particles,
                   const Scalars& flux_divergence, BalanceTerms& terms);

/// Add the momentum of the water that enters particles as their pores grow in a step, at the velocity of the
/// particle. Before the particles move.
void enter_exchange(const Problem& problem, double dt, const Particles& particles, BalanceTerms& terms);

/// Residuals of the balances at the present state, and the numerical dissipation.
struct BalanceErrors {
    double numerical_loss = 0.0;   // kinetic energy lost between particles and nodes and at walls [J/m]
    double energy_error = 0.0;     // residual / sum of the sizes of all terms [-]
    double momentum_error_x = 0.0; // momentum less initial momentum, impulses and exchange [N s/m]
    double momentum_error_y = 0.0;
    double water_error = 0.0; // (water content - initial content + outflow) / initial content [-]
};

BalanceErrors balance(const Problem& problem, const State& state);

/// The part of it that the watchdog asks for again and again.
struct EnergyBalance {
    double kinetic = 0.0;        // at present [J/m]
    double numerical_loss = 0.0; // [J/m]
    double residual = 0.0;       // below zero where energy is missing [J/m]
    double turnover = 0.0;       // sum of the sizes of all terms [J/m]
    double error() const { return turnover > 0.0 ? residual / turnover : 0.0; }
};

/// Zero without balances.
EnergyBalance energy_balance(const Problem& problem, const State& state);

/// What there was at the opening, and the sizes of the works from outside since [J/m].
double energy_put_in(const BalanceTerms& terms);

/// sum n V p (p/2 + d) / K_w of the excess pressure p and of the tension d that is missing to it: energy
/// stored in the water and in its cavities [J/m].
double storage_energy(const Problem& problem, const Particles& particles);

/// sum n V (1 + p / K_w), p the whole pressure: the pore water's volume without pressure [m3/m].
double water_content(const Problem& problem, const Particles& particles);

} // namespace quicksand
