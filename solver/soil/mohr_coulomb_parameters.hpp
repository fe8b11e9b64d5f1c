// Strength and stiffness of a Mohr-Coulomb soil.
#pragma once

#include "solver/soil/law_key.hpp"
#include "solver/soil/maxwell_elements.hpp"

#include <limits>
#include <span>
#include <string_view>

namespace quicksand {

struct MohrCoulomb {
    double shear_modulus = 0.0;  // G [Pa]
    double poisson_ratio = 0.0;  // nu, drained [-]
    double cohesion = 0.0;       // c [Pa]
    double friction_angle = 0.0; // phi [rad]
    double dilation_angle = 0.0; // psi, at most phi [rad]
    /// t; the surface itself ends in tension at c / tan phi, beyond which t has no meaning [Pa].
    double tension_strength = std::numeric_limits<double>::infinity();
    double damping_ratio = 0.0;                         // of vibrations below failure, 0: none [-]
    double damping_frequency = usual_damping_frequency; // middle of the band that is damped [Hz]

    bool operator==(const MohrCoulomb&) const = default;
};

/// Largest mean tension that cohesion and friction allow: c / tan phi, infinite without friction [Pa].
double surface_tip(const MohrCoulomb& law);

/// The law with cohesion and tan(friction) divided by `factor`, and what has to follow: the dilation angle is
/// at most the friction angle. The tension strength is cohesion's kin and is divided, too.
MohrCoulomb reduced(const MohrCoulomb& law, double factor);

inline std::string_view name_of(const MohrCoulomb&)
{
    return "mohr_coulomb";
}

std::span<const LawKey<MohrCoulomb>> keys_of(const MohrCoulomb& law);

inline bool flows_at_constant_volume(const MohrCoulomb&)
{
    return true;
}

inline double cohesion_of(const MohrCoulomb& law)
{
    return law.cohesion;
}

inline bool has_strength(const MohrCoulomb&)
{
    return true;
}

double lame_modulus(const MohrCoulomb& law);        // lambda [Pa]
double constrained_modulus(const MohrCoulomb& law); // lambda + 2 G, elastic [Pa]
double shear_modulus(const MohrCoulomb& law);       // G [Pa]

} // namespace quicksand
