// Linear elasticity with the perfectly plastic surface of Mohr and Coulomb and a cut-off of tension, in rate
// form: strength of friction and cohesion, without liquefaction.
//
// With principal stresses s_1 >= s_2 >= s_3 (tension positive; the out-of-plane stress is one of them)
//   shear    (1 + sin phi) s_i - (1 - sin phi) s_j <= 2 c cos phi   for i < j
//   tension  s_i <= t
// Plastic strain on a shear plane goes along (1 + sin psi) e_i - (1 - sin psi) e_j, on a tension plane along
// e_i. The elastic trial stress returns to the surface by the implicit rule of Koiter, in closed form on
// every plane, edge and corner (surface and its edges: de Souza Neto, Peric and Owen 2008, chapter 8).
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/soil/law_interface.hpp"
#include "solver/soil/mohr_coulomb_parameters.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace quicksand {

/// Of the particles [first, last): the elastic modulus, for plastic flow only softens.
ParticleModuli particle_moduli(const MohrCoulomb& law, std::size_t first, std::size_t last,
                               const Particles& particles);

/// Add the stress of the strain L dt to the particles [first, last), rotated stress given.
void update_stress(const MohrCoulomb& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles);

/// Principal stresses beyond the surface: the largest is more than the least one bears, or tension is.
std::string objection_to_stress(const MohrCoulomb& law, std::size_t p, const Particles& particles);

/// t = s sin phi + c cos phi, where the out-of-plane stress is the middle one.
std::optional<FailureLine> failure_line_of(const MohrCoulomb& law);

} // namespace quicksand
