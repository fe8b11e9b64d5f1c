#include "solver/run/residual_strength.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

constexpr double strength_step = 1.05; // of neighbouring materials [-]

/// The material of liquefied sand: as stiff as before, with a strength that hangs on no stress.
Material liquefied(const Material& material, double strength)
{
    constexpr double poisson_ratio = 0.3;
    Material result = material;
    result.name += " liquefied";
    MohrCoulomb law;
    law.shear_modulus = std::visit([](const auto& each) { return shear_modulus(each); }, material.law);
    law.poisson_ratio = poisson_ratio;
    law.cohesion = strength;
    result.law = law;
    result.volumetric_strain = VolumetricStrain::cell; // it flows at constant volume
    return result;
}

} // namespace

std::size_t give_residual_strength(const ResidualStrength& residual, Problem& problem, State& state)
{
    Particles& particles = state.particles;
    if (particles.pore_pressure.empty()) return 0;
    std::map<std::pair<std::int32_t, int>, std::int32_t> made; // (material, step of strength) -> material
    std::size_t count = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::int32_t before = particles.material[p];
        const Material& material = problem.materials[static_cast<std::size_t>(before)];
        const double stress = particles.initial_vertical_effective_stress[p];
        if (!is_wet(material) || !has_strength(material.law) || !(stress > 0.0)) continue;
        if (risen_pore_pressure(problem, particles, p) < residual.liquefied_ru * stress) continue;
        const int step =
            static_cast<int>(std::lround(std::log(residual.ratio * stress) / std::log(strength_step)));
        const auto next = static_cast<std::int32_t>(problem.materials.size());
        const auto [entry, is_new] = made.try_emplace({before, step}, next);
        if (is_new) {
            Material sand = liquefied(material, std::pow(strength_step, step));
            sand.part_of = material.part_of.value_or(static_cast<std::size_t>(before));
            problem.materials.push_back(std::move(sand));
        }
        particles.material[p] = entry->second;
        ++count;
    }
    return count;
}

} // namespace quicksand
