// Compressible neo-Hookean elasticity, for verification at large strain:
//   P = lambda ln J F^-T + mu (F - F^-T),  sigma = [lambda ln J I + mu (F F^T - I)] / J
// in plane strain (F_zz = 1). The stress follows from the deformation since the reference, not from rates:
// the body is free of stress as drawn, and a stage that sets a new reference loses its stress.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/soil/law_key.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace quicksand {

struct NeoHookean {
    double shear_modulus = 0.0; // mu [Pa]
    double poisson_ratio = 0.0; // at small strain [-]

    bool operator==(const NeoHookean&) const = default;
};

double lame_modulus(const NeoHookean& law);        // lambda [Pa]
double constrained_modulus(const NeoHookean& law); // lambda + 2 mu, at small strain [Pa]
double shear_modulus(const NeoHookean& law);       // mu [Pa]

/// Of the particles [first, last) at their present stretches.
ParticleModuli particle_moduli(const NeoHookean& law, std::size_t first, std::size_t last,
                               const Particles& particles);

/// Set the stress of the particles [first, last) from their deformation gradients.
void update_stress(const NeoHookean& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles);

inline std::string_view name_of(const NeoHookean&)
{
    return "neo_hookean";
}

std::span<const LawKey<NeoHookean>> keys_of(const NeoHookean& law);

inline bool yields(const NeoHookean&)
{
    return false;
}

inline bool bears_stress_as_drawn(const NeoHookean&)
{
    return false;
}

} // namespace quicksand
