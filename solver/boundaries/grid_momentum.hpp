// The momentum balances on the nodes, with the velocity conditions inside the solve.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"

#include <vector>

namespace quicksand {

/// Flux per force and time of the nodes; symmetric 2 x 2, off-diagonal only at dashpots, wall rows and
/// slanted layers [m/kg].
struct NodeCompliances {
    std::vector<double> xx, xy, yy;
};

/// Velocities of the two phases in one direction [m/s].
struct PhaseVelocities {
    double solid, fluid;
};

/// Split the drag of every node into a part on the velocities before the step, a force known from the sums,
/// and the rest, which stays implicit. With x = dt C (1/m_s + 1/m_w), half of it is known up to
/// x = 2 `strong`, the drag at the time of the forces, second order in time; beyond it `strong` C / x. With 1
/// nothing is then left of the old relative velocity, with 1/2 half of its impulse, so that none swings
/// whatever x. A steady seepage is exact for every split. Once in a step, on sums whose tied nodes are
/// gathered.
void centre_drag(double dt, double strong, std::vector<TwoPhaseSums>& sums);

/// `strong` of the schemes: a motion that changes its sign in every step, the first to grow, meets 2 C / x
/// less than the drag in explicit steps, and C / x in semi-implicit ones, whose steps are longer [-].
inline constexpr double explicit_strong_drag = 1.0, semi_implicit_strong_drag = 0.5;

/// Backward Euler on the drag alone: the 2 x 2 system of one node and direction
///   (m_s + dt C) v_s - dt C v_w = b_s,   -dt C v_s + (m_w + dt C) v_w = b_w
/// in a form without cancellation, valid for dt C from 0 to infinity.
PhaseVelocities solve_drag(double mass_solid, double mass_fluid, double dt_drag, double impulse_solid,
                           double impulse_fluid);

/// Porosity of the saturated soil at a node; zero where there is no water [-].
double node_porosity(const Problem& problem, const TwoPhaseSums& node);

/// The flux of grains and water that follows from a node's velocities.
void set_flux(const Problem& problem, const TwoPhaseSums& node, TwoPhaseMotion& motion);

/// Set a node's velocities, with their flux and change.
void set_velocities(const Problem& problem, const TwoPhaseSums& node, const Vector2& solid,
                    const Vector2& fluid, TwoPhaseMotion& motion);
void set_velocity(const SinglePhaseSums& node, const Vector2& velocity, SinglePhaseMotion& motion);

/// What local damping adds to a force [N/m] on a node of a momentum [N s/m]: against the momentum, the part
/// `damping` of the force; less where the momentum is small beside what the force adds in dt. A sense that
/// jumps there would let rounding decide over the whole damping: bodies and their mirror would settle
/// differently.
double local_damping(double damping, double dt, double force, double momentum);

/// Momentum and impulses of the known forces on a node's grains and water.
struct NodeImpulses {
    Vector2 solid, fluid; // [N s/m]
};

/// Over dt, with all forces of the sums; `acceleration` as in solve_two_phase_momentum.
NodeImpulses two_phase_impulses(const Problem& problem, double dt, double acceleration,
                                const TwoPhaseSums& node);

/// The same of a body that moves as one phase; `damping` as in solve_single_phase_momentum [N s/m].
Vector2 single_phase_impulse(const Problem& problem, double dt, double acceleration, double damping,
                             const SinglePhaseSums& node);

/// Add the sums of tied nodes to their masters.
void gather_tied_sums(const NodeConditions& conditions, std::vector<TwoPhaseSums>& sums);
void gather_tied_sums(const NodeConditions& conditions, std::vector<SinglePhaseSums>& sums);
void gather_tied_sums(const NodeConditions& conditions, std::vector<OuterForce>& outer);

/// Give tied nodes their masters' velocities.
template <class Motion>
void spread_tied_motion(const NodeConditions& conditions, std::vector<Motion>& motion)
{
    for (const TiedNodes& tie : conditions.tied) motion[tie.node] = motion[tie.master];
}

/// Velocities at t + dt of both phases; `acceleration` is the horizontal acceleration of the base [m/s2].
///   water  m_w dv_w/dt = n_i F^p - m_w a - C (v_w - v_s)
///   grains m_s dv_s/dt = f' + (1-n_i) F^p + (m_s + m_w - rho_w V) g - m_s a + C (v_w - v_s)
/// F^p is the force of the excess pressure; the static pressure carries the water's weight and leaves the
/// grains their buoyant weight.
void solve_two_phase_momentum(const Problem& problem, const NodeConditions& conditions, double dt,
                              double acceleration, const std::vector<TwoPhaseSums>& sums,
                              std::vector<TwoPhaseMotion>& motion);

/// What a unit force of the pressure on each node does to its flux (1-n) v_s + n v_w in a unit of time, with
/// drag over dt and the velocity conditions inside; zero at nodes without soil.
void set_pressure_compliances(const Problem& problem, const NodeConditions& conditions, double dt,
                              const std::vector<TwoPhaseSums>& sums, NodeCompliances& compliances);

/// Velocities at t + dt of a body that moves as one phase. `damping` is the local damping factor: the part of
/// a node's force that is taken away while it accelerates the node, and added while it brakes it [-].
void solve_single_phase_momentum(const Problem& problem, const NodeConditions& conditions, double dt,
                                 double acceleration, double damping,
                                 const std::vector<SinglePhaseSums>& sums,
                                 std::vector<SinglePhaseMotion>& motion);

} // namespace quicksand
