// How particles move, turn and deform with the velocities gathered for them.
#pragma once

#include "solver/problem.hpp"
#include "solver/state.hpp"

namespace quicksand {

/// x += dt v, r_a <- (I + dt L) r_a, V <- det(I + dt L) V; with water also n = 1 - V_grains / V.
void advance_domains(const Problem& problem, double dt, Particles& particles);

/// Turn the stress by the step's rotation (Hughes and Winget 1980: half-angle tangent w/2, w = dt (L_yx -
/// L_xy)/2), then add each material's stress of the step's strain.
void update_effective_stress(const Problem& problem, double dt, Particles& particles);

} // namespace quicksand
