#include "solver/problem/solid_mixture.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/overload.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace quicksand {

void make_solid(double density, const std::optional<Water>& water, Material& material)
{
    constexpr double usual_porosity = 0.5; // [-]
    constexpr double conductivity = 1e-14; // next to nothing [m/s]
    const double water_density = water ? water->density : 0.0;
    // a solid lighter than half the water keeps grains of positive mass
    material.porosity = std::min(usual_porosity, 0.5 * density / std::max(water_density, 1.0));
    material.grain_density = (density - material.porosity * water_density) / (1.0 - material.porosity);
    material.hydraulic_conductivity = conductivity;
    material.conductivity_gravity = standard_gravity;
    material.permeability_law = PermeabilityLaw::constant;
    material.has_pores = false;
}

void soften_solids(const std::vector<WaveSpeeds>& fastest, Problem& problem)
{
    double of_soil = 0.0; // [m/s]
    for (std::size_t m = 0; m < fastest.size(); ++m)
        if (problem.materials[m].has_pores) of_soil = std::max(of_soil, fastest[m].skeleton);
    if (of_soil == 0.0) return;
    for (std::size_t m = 0; m < fastest.size(); ++m) {
        Material& material = problem.materials[m];
        if (material.has_pores || fastest[m].skeleton <= of_soil) continue;
        const double part = of_soil / fastest[m].skeleton;
        std::visit(Overload{[&](LinearElastic& law) { law.shear_modulus *= part * part; },
                            [&](MohrCoulomb& law) { law.shear_modulus *= part * part; },
                            [](auto&) { ENSURE(false); }}, // no law of solids
                   material.law);
    }
}

} // namespace quicksand
