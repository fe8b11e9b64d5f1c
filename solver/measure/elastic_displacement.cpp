#include "solver/measure/elastic_displacement.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace quicksand {

double drawn_height(const Particles& particles)
{
    const auto [lowest, highest] =
        std::minmax_element(particles.reference_position.y.begin(), particles.reference_position.y.end());
    return *highest - *lowest;
}

double elastic_displacement(const Problem& problem, const Particles& particles)
{
    double mass = 0.0, volume = 0.0, softest = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        mass += particles.mass_solid[p];
        volume += particles.volume[p];
    }
    for (const Material& material : problem.materials) {
        softest =
            std::min(softest, std::visit([](const auto& law) { return shear_modulus(law); }, material.law));
    }
    const double height = drawn_height(particles);
    return mass / volume * problem.gravity * height * height / softest;
}

} // namespace quicksand
