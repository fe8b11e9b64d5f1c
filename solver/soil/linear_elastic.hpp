// Isotropic linear elasticity in rate form: the objective (Jaumann) rate of the effective stress is linear
// in the strain rate; with a damping ratio Maxwell elements stand beside it while the soil is shaken.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/soil/law_interface.hpp"
#include "solver/soil/law_key.hpp"
#include "solver/soil/maxwell_elements.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace quicksand {

struct LinearElastic {
    double shear_modulus = 0.0;                         // G [Pa]
    double poisson_ratio = 0.0;                         // nu, drained [-]
    double damping_ratio = 0.0;                         // of vibrations, 0: none [-]
    double damping_frequency = usual_damping_frequency; // middle of the band that is damped [Hz]

    bool operator==(const LinearElastic&) const = default;
};

/// lambda = 2 G nu / (1 - 2 nu) [Pa]
double lame_modulus(const LinearElastic& law);

/// M = lambda + 2 G, the stiffest response to one-dimensional strain [Pa]
double constrained_modulus(const LinearElastic& law);

/// G [Pa]
double shear_modulus(const LinearElastic& law);

/// Of the particles [first, last): all the same.
ParticleModuli particle_moduli(const LinearElastic& law, std::size_t first, std::size_t last,
                               const Particles& particles);

/// Add the elastic stress of the strain L dt to the particles [first, last), damped where there is a step of
/// Maxwell elements.
void add_elastic_stress(const LinearElastic& law, const std::optional<MaxwellStep>& damping, double dt,
                        std::size_t first, std::size_t last, Particles& particles);

/// The same with the law's own damping, rotated stress given.
void update_stress(const LinearElastic& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles);

inline std::string_view name_of(const LinearElastic&)
{
    return "linear_elastic";
}

std::span<const LawKey<LinearElastic>> keys_of(const LinearElastic& law);

inline bool yields(const LinearElastic&)
{
    return false;
}

} // namespace quicksand
