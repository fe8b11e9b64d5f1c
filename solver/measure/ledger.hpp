// What a run's steps have exchanged with the outside and inside, kept step by step: works, drag, impulses,
// water.
//
// The nodal balance of an explicit step has an exact identity: with v the mean of the velocities before and
// after, m (v1^2 - v0^2) / 2 = dt f . v for every force f. Works are therefore nodal forces times the mean
// velocity, and belong to the time of the velocities, half a step before that of the stresses. What remains
// between the kinetic energy of the nodes and that of the particles is lost in the transfers and at the
// walls: the scheme's own dissipation, which is a term of its own.
#pragma once

#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

struct NodeConditions;

/// Open the ledger at the present state: everything is counted from here.
void open_ledger(const Problem& problem, State& state);

/// What the ledger needs to know of the nodes: 0 a tied node, which its master stands for; 1 free; 2 held by
/// a wall, whose reaction is what the known forces leave of the change of momentum.
std::vector<std::uint8_t> ledger_nodes(const NodeConditions& conditions);

/// Count what the known forces leave at a node as a reaction in this step: dashpots move with the soil.
void count_reaction(std::size_t node, std::vector<std::uint8_t>& kinds);

/// Enter the works of one step's forces on the nodes; `acceleration` is that of the base [m/s2], `outer` what
/// of the forces comes from outside, or nothing.
void enter_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                 double acceleration, const std::vector<TwoPhaseSums>& sums,
                 const std::vector<OuterForce>& outer, const std::vector<TwoPhaseMotion>& motion,
                 Ledger& ledger);
void enter_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                 double acceleration, const std::vector<SinglePhaseSums>& sums,
                 const std::vector<OuterForce>& outer, const std::vector<SinglePhaseMotion>& motion,
                 Ledger& ledger);

/// Enter the water that left the soil in a step: dt sum V (div[(1-n) v_s + n v_w] - div v_s). Before the
/// particles move.
void enter_outflow(const Problem& problem, double dt, const Particles& particles,
                   const Scalars& flux_divergence, Ledger& ledger);

/// Enter the momentum of the water that comes with the growth of its particle's pores in a step, at the
/// particle's velocity. Before the particles move.
void enter_exchange(const Problem& problem, double dt, const Particles& particles, Ledger& ledger);

/// Balances at the present state.
struct LedgerBalance {
    double numerical_loss = 0.0;   // kinetic energy lost between particles and nodes and at walls [J/m]
    double energy_error = 0.0;     // what the terms leave / what they have turned over [-]
    double momentum_error_x = 0.0; // momentum less opening, impulses and exchange [N s/m]
    double momentum_error_y = 0.0;
    double water_error = 0.0; // water content less opening, plus outflow / opening [-]
};

LedgerBalance balance(const Problem& problem, const State& state);

/// sum n V p^2 / (2 K_w) of the excess pressure: energy stored in the water [J/m].
double storage_energy(const Problem& problem, const Particles& particles);

/// sum n V (1 + p / K_w), p the whole pressure: the pore water's volume without pressure [m3/m].
double water_content(const Problem& problem, const Particles& particles);

} // namespace quicksand
