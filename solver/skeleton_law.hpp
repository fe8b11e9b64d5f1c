// The constitutive laws of the grain skeleton behind one small interface.
//
// A law is a plain struct of parameters with three functions: `update_stress`, `constrained_modulus` and
// `shear_modulus`. Laws are visited once per run of particles, never per particle.
#pragma once

#include "solver/linear_elastic.hpp"
#include "solver/mohr_coulomb.hpp"
#include "solver/neo_hookean.hpp"

#include <variant>

namespace quicksand {

using SkeletonLaw = std::variant<LinearElastic, NeoHookean, MohrCoulomb>;

} // namespace quicksand
