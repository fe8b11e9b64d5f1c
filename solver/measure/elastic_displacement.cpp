#include "solver/measure/elastic_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

namespace quicksand {

double drawn_height(const Particles& particles)
{
    const auto [lowest, highest] =
        std::minmax_element(particles.reference_position.y.begin(), particles.reference_position.y.end());
    return *highest - *lowest;
}

namespace {

/// Weight of the grains over their volume with pores [N/m3].
double unit_weight(const Problem& problem, const Particles& particles)
{
    double mass = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        mass += particles.mass_solid[p];
        volume += particles.volume[p];
    }
    return mass / volume * problem.gravity;
}

double shear_modulus_of(const Material& material)
{
    return std::visit([](const auto& law) { return shear_modulus(law); }, material.law);
}

} // namespace

double softest_shear_modulus(const Problem& problem)
{
    double softest = std::numeric_limits<double>::infinity();
    for (const Material& material : problem.materials)
        softest = std::min(softest, shear_modulus_of(material));
    return softest;
}

double mean_shear_compliance(const Problem& problem, const Particles& particles)
{
    double sum = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        sum += particles.volume[p] / shear_modulus_at(material.law, p, particles);
        volume += particles.volume[p];
    }
    return sum / volume;
}

double elastic_displacement(const Problem& problem, const Particles& particles)
{
    const double height = drawn_height(particles);
    return unit_weight(problem, particles) * height * height / softest_shear_modulus(problem);
}

double elastic_displacement_of_layers(const Problem& problem, const Particles& particles)
{
    const Scalars& y = particles.reference_position.y;
    const double lowest = *std::min_element(y.begin(), y.end()), height = drawn_height(particles);
    const double rows = std::max(1.0, std::ceil(height / problem.grid.cell_size));
    std::vector<double> softest(static_cast<std::size_t>(rows), std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double share = height > 0.0 ? (y[p] - lowest) / height : 0.0;
        double& G = softest[static_cast<std::size_t>(std::min(share * rows, rows - 1.0))];
        G = std::min(G, shear_modulus_of(problem.materials[static_cast<std::size_t>(particles.material[p])]));
    }
    double compliance = 0.0; // int (top - y)/G dy over the square of the height [1/Pa]
    for (std::size_t row = 0; row < softest.size(); ++row)
        compliance += (1.0 - (static_cast<double>(row) + 0.5) / rows) / rows / softest[row];
    return 2.0 * unit_weight(problem, particles) * height * height * compliance;
}

} // namespace quicksand
