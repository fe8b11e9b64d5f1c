// Small motions from the present state: elastic, with the moduli of unloading, and without what is known
// beforehand.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// The problem without weight, and without cavities, which are not linear in the motion.
Problem form_of_small_motion(const Problem& problem);

/// The state at rest and without balances, so that nothing is entered in them.
State resting_copy(const State& state);

/// Moduli of the particles for unloading [Pa].
struct TangentModuli {
    Scalars constrained; // M
    Scalars shear;       // G
};

TangentModuli tangent_moduli(const Problem& problem, const Particles& particles);

/// stress = - (elastic stress of the particles' velocity gradients in a unit of time) [Pa]: the forces
/// - sum V stress grad phi that scatter gives are then K v.
void set_restoring_stress(const TangentModuli& moduli, Particles& particles);

} // namespace quicksand
