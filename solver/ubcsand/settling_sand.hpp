// Sand of UBCSAND while it settles under gravity, drained: elastic with its shear modulus and a Poisson's
// ratio of its own, plastic at its failure limit, without memory of cycles.
//
// Why        The drained bulk modulus of UBCSAND is that of unloading: gravity applied with it leaves hardly
//            any horizontal stress (K_0 = 0.016 for the generic set), beyond failure. nu = 1/3 gives 0.5.
// Failure    Perfectly plastic at t = (s + a) sin phi_f without volume change, so that a slope starts shaking
//            from a stress that the sand can carry; no mean stress below the floor, so no tension. Within
//            the stress of one cell's weight the limit is that of this stress: single particles at the
//            surface of a slope are held by few nodes only and would creep without end.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/soil/law_interface.hpp"
#include "solver/ubcsand/ubcsand.hpp"

#include <cstddef>
#include <string_view>

namespace quicksand {

struct SettlingSand {
    UbcSand sand;
    double surface_stress = 0.0; // weight of a cell of the soil, per area [Pa]

    bool operator==(const SettlingSand&) const = default;
};

/// Without the specific volumes, and without the weight of a cell.
UbcSand without_weight(const UbcSand& law);
SettlingSand without_weight(const SettlingSand& law);

/// With tan(phi_f) and the cohesion divided by the factor.
SettlingSand reduced(const SettlingSand& law, double factor);

inline bool has_strength(const SettlingSand&)
{
    return true;
}

inline std::string_view name_of(const UbcSand&)
{
    return "ubcsand";
}

inline StressFloor stress_floor_of(const SettlingSand& law)
{
    return {law.sand.s_min, "stress_floor"};
}

/// UBCSAND while it settles, and its strength, which is reduced in this form.
SettlingSand settling_form(const UbcSand& law, double cell_weight);

inline bool has_strength(const UbcSand&)
{
    return true;
}

/// M = 2 G (1 - nu)/(1 - 2 nu) at a mean stress of one atmosphere [Pa].
double constrained_modulus(const SettlingSand& law);

/// G at a mean stress of one atmosphere [Pa].
double shear_modulus(const SettlingSand& law);

/// Of the particles [first, last) at their present stress.
ParticleModuli particle_moduli(const SettlingSand& law, std::size_t first, std::size_t last,
                               const Particles& particles);

/// Add the stress of the strain L dt to the particles [first, last), rotated stress given.
void update_stress(const SettlingSand& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles);

} // namespace quicksand
