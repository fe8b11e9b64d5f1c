// Absorbing boundaries: dashpots on the curve (Lysmer and Kuhlemeyer 1969).
//
// A half-space beyond the curve reacts to a plane wave at normal incidence with the stress
//   sigma_n = - rho V_p v_n,   tau = - rho V_s v_t
// on the soil. With the rock's own density and wave speeds this is a compliant base. The frame moves with the
// motion that the rock would have without the soil, the outcrop motion, as with a rigid base: the incoming
// wave is half of it, its stress 2 rho V (v_outcrop / 2 - v / 2) = rho V (v_outcrop - v) is that of the
// dashpots on velocities relative to the outcrop (Joyner and Chen 1975), and the acceleration of the frame is
// the body force that the base's acceleration is anyway. The dashpots act on the grains (and through an
// impervious curve on the water's normal velocity as well) and are implicit at each node (Crank-Nicolson), so
// that they do not limit the step.
//
// Without parameters of a rock the half-space has the present stiffness of the soil beside the curve: sand
// that softens has soil of the same stiffness beyond the curve, and a run that is resumed has the same
// dashpots. The modulus is that of unloading, which governs waves of small amplitude.
//
// While the soil settles the curve is held; the forces that held it stay when the dashpots take over.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// The dashpots of a node, a symmetric tensor [N s/m2].
struct Dashpot {
    std::size_t node = 0;
    double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// Impedances of what lies beyond a boundary that absorbs waves, beside the particle p.
Impedance impedance(const Problem& problem, const Boundary& boundary, const Particles& particles,
                    std::size_t p);

/// Where a piece brakes its nodes: as it loads them, but a piece that lies outside its particle's domain has
/// negative fractions of a load for some corners, where a dashpot would drive the soil. They become zero, and
/// the others smaller so that they add up to 1.
PresentPiece braking_piece(PresentPiece piece);

/// The dashpots of a piece as a whole; its node is not set.
Dashpot dashpot_of(const Problem& problem, const Boundary& boundary, const CarriedPiece& carried);

/// The dashpots of all boundaries that absorb waves, each node once, in the order of the nodes.
void gather_dashpots(const Problem& problem, const Particles& particles, const NodeConditions& conditions,
                     ParticlePlaces& places, std::vector<Dashpot>& dashpots);

/// What a dashpot takes of its node's velocity over dt, with the mean of the velocities before and after the
/// step: v'' = v' - r dt C (v + v'')/2, r the response of the grains.
struct Braking {
    Eigen::Matrix2d half;   // dt C / 2 [kg/m]
    Eigen::Matrix2d factor; // r dt C / 2 [-]
    Eigen::Matrix2d left;   // (1 + factor)^-1: velocity left of one given by other forces [-]
};
Braking braking_of(const Dashpot& dashpot, double dt, const NodeResponses& responses);

/// Put the dashpots' impulses on the velocities, after the momentum balance.
void brake_by_dashpots(const Problem& problem, const NodeConditions& conditions, double dt,
                       const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                       std::vector<TwoPhaseMotion>& motion);
void brake_by_dashpots(const NodeConditions& conditions, double dt, const std::vector<Dashpot>& dashpots,
                       const std::vector<SinglePhaseSums>& sums, std::vector<SinglePhaseMotion>& motion);

/// Call visit(boundary, piece) for all that carries held forces, in the order of State::reactions.
template <class Visit>
void for_each_held_piece(const Problem& problem, Visit&& visit)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!lets_go(boundary.soil)) continue;
        for (const BoundaryPiece& piece : boundary.pieces) visit(boundary, piece);
        for (const BoundaryPiece& holder : boundary.holders) visit(boundary, holder);
    }
}

/// Add the held forces at their nodes, in the shaking.
void add_held_reactions(const Problem& problem, const State& state, ParticlePlaces& places,
                        std::vector<NodalForce>& forces);

} // namespace quicksand
