// The constitutive laws of the grain skeleton behind one small interface.
//
// A law is a plain struct of parameters with four functions: `update_stress`, `particle_moduli`, and
// `constrained_modulus` and `shear_modulus` where no particle is at hand (at one atmosphere when they follow
// the stress). Laws are visited once per run of particles, never per particle.
#pragma once

#include "solver/soil/linear_elastic.hpp"
#include "solver/soil/mohr_coulomb.hpp"
#include "solver/soil/neo_hookean.hpp"
#include "solver/soil/settling_sand.hpp"
#include "solver/soil/ubcsand_particles.hpp"

#include <variant>

namespace quicksand {

using SkeletonLaw = std::variant<LinearElastic, NeoHookean, MohrCoulomb, UbcSand, SettlingSand>;

} // namespace quicksand
