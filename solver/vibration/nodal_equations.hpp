// The equations of the nodes in small motion: the stiffness K of what a step treats explicitly, and the
// response to forces of all else.
//
// Velocities stand at half steps, stresses at whole ones. A motion that changes its sign in every step
// (growth factor z = -1) is the first to become unstable when dt grows. Put in the equations of a step it
// gives
//   (dt^2 K - A) v = 0
//   explicit, one velocity     A = 4 R                                   K = skeleton, and water if undrained
//   explicit, two velocities   A = 4 R + 2 dt (C' - C'') J               K = skeleton + water
//   semi-implicit              A = 4 R + 2 dt (C' - C'') J + dt^2 Q      K = skeleton
// with the lumped masses R, the drag C J (J: relative motion; C', C'' its parts after and before the step)
// and the stiffness Q of the water. The step is stable if dt^2 K - A has no positive eigenvalue: for any v
// the factors z are the roots of a quadratic with real coefficients, whose product is at most 1, and none of
// them passes -1 before. Walls are inside: all v are motions that they allow.
//
// Particles give the nodes back only F v of their motion, their velocity and affine velocity gathered and
// scattered again. Nodes then answer a force as with
//   S = A^-1 + A^-1 4 R (1 - F) A^-1
// in the place of A^-1: exact without drag and water for motions that particles carry (F = 1) and for those
// that they lose (F = 0, at nodes that a particle just touches), a little more than true between them.
#pragma once

#include "solver/particles/particles.hpp"

namespace quicksand {

/// Vectors hold the same number of components for every node; forces and velocities are paired so that their
/// scalar product is a power.
class NodalEquations {
public:
    virtual ~NodalEquations() = default;

    /// Roots of the masses that the components move, zero where nothing moves [kg^1/2].
    virtual Scalars root_masses() const = 0;

    /// force = K velocity [N/s].
    virtual void deform(const Scalars& velocity, Scalars& force) = 0;

    /// velocity = S force. Throws NumericalError.
    virtual void respond(const Scalars& force, Scalars& velocity) = 0;
};

} // namespace quicksand
