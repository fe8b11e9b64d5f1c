#include "solver/verification/studies/large_strain_consolidation_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/large_strain_consolidation.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <string>

namespace quicksand {

namespace {

/// c_v of the layer as it starts, with incompressible water [m2/s].
double consolidation_coefficient(const SaturatedSoil& soil)
{
    return soil.hydraulic_conductivity * soil.constrained_modulus /
           (soil.water_density * soil.conductivity_gravity);
}

LargeStrainConsolidation read_large_strain_consolidation(const Problem& problem, const State& state,
                                                         const Layer& layer)
{
    const Material& material =
        problem.materials.at(static_cast<std::size_t>(state.particles.material.front()));
    if (material.permeability_law != PermeabilityLaw::specific_volume_squared) {
        throw InputError("the verification needs permeability_law = \"specific_volume_squared\"");
    }
    if (problem.strain != StrainForm::large) throw InputError("the verification needs large strain");
    const double load = steady_load_on(problem, layer.top);
    if (!(load > 0.0) || std::abs(state.particles.pore_pressure.front() - load) > 1e-9 * load) {
        throw InputError("the verification needs a load on the top that initial.excess_pore_pressure equals");
    }
    return {layer.soil.constrained_modulus, load};
}

} // namespace

std::vector<StudyError> large_strain_consolidation_study(const Problem& problem, State state)
{
    constexpr std::array<std::pair<double, const char*>, 3> time_factors = {
        {{0.1, "0.1"}, {0.3, "0.3"}, {1.0, "1"}}};
    const Layer layer = read_layer(problem, state);
    const LargeStrainConsolidation exact = read_large_strain_consolidation(problem, state, layer);
    const double H = layer.height(), c_v = consolidation_coefficient(layer.soil);
    const Particles& particles = state.particles;
    const auto depth = [&](std::size_t p) { return (layer.top - particles.reference_position.y[p]) / H; };
    std::vector<StudyError> pressures, settlements;
    for (const auto& [T, text] : time_factors) {
        run(problem, T * H * H / c_v, {}, state);
        const double pressure = root_mean_square(particles, [&, T = T](std::size_t p) {
            return (particles.pore_pressure[p] - pore_pressure(exact, depth(p), T)) / exact.load;
        });
        const std::size_t top = highest_particle(particles);
        const double sunk = particles.reference_position.y[top] - particles.position.y[top];
        const double expected = H * settlement_ratio(exact, depth(top), T);
        pressures.push_back({std::string("pressure at T = ") + text, "L2 / load", pressure});
        settlements.push_back(
            {std::string("settlement at T = ") + text, "surface / exact", std::abs(sunk / expected - 1.0)});
    }
    const double volume = root_mean_square(particles, [&](std::size_t p) {
        return deformation_gradient(particles, p).determinant() - volume_ratio(exact, depth(p), 1.0);
    });
    pressures.insert(pressures.end(), settlements.begin(), settlements.end());
    pressures.push_back({"volume ratio at T = 1", "L2", volume});
    return pressures;
}

} // namespace quicksand
