#include "solver/verification/terzaghi_study.hpp"

#include "solver/failure.hpp"
#include "solver/simulation.hpp"
#include "solver/verification/layer.hpp"
#include "solver/verification/terzaghi.hpp"

#include <array>
#include <cmath>
#include <string>

namespace quicksand {

namespace {

/// The layer and the load that consolidate it.
struct Consolidation {
    Layer layer;
    double initial_pressure = 0.0; // p_0 [Pa]
    double load = 0.0;             // on the top, as drawn [Pa]

    double duration(double time_factor) const // t of a time factor [s]
    {
        const double H = layer.height();
        return time_factor * H * H / layer.soil.consolidation_coefficient();
    }
    double depth_ratio(double y) const { return (layer.top - y) / layer.height(); }
    double final_settlement() const // [m]
    {
        return initial_pressure * layer.height() / layer.soil.constrained_modulus;
    }
};

Consolidation read_consolidation(const Problem& problem, const State& state)
{
    Consolidation consolidation;
    consolidation.layer = read_layer(problem, state);
    if (is_closed(problem, consolidation.layer.top)) {
        throw InputError("the verification needs a column with a free and drained top");
    }
    consolidation.initial_pressure = state.particles.pore_pressure.front();
    if (!(consolidation.initial_pressure > 0.0)) {
        throw InputError("the verification needs initial.excess_pore_pressure");
    }
    consolidation.load = load_on(problem, consolidation.layer.top, 0.0);
    return consolidation;
}

/// Velocities of grains and water on the series, positive upward [m/s].
struct Velocities {
    double solid = 0.0, fluid = 0.0;
};

constexpr double small = 1e-4; // step of differences: of T, and of the depth [-]

Velocities velocities_on_series(const Consolidation& consolidation, double Z, double T)
{
    const SaturatedSoil& soil = consolidation.layer.soil;
    const double mobility = soil.hydraulic_conductivity / (soil.water_density * soil.conductivity_gravity);
    const double sinking = (terzaghi_settlement_degree(Z, T * (1.0 + small)) -
                            terzaghi_settlement_degree(Z, T * (1.0 - small))) /
                           consolidation.duration(2.0 * small * T);
    const double slope = (terzaghi_pressure_ratio(Z + small, T) - terzaghi_pressure_ratio(Z - small, T)) /
                         (2.0 * small * consolidation.layer.height());
    Velocities velocities;
    velocities.solid = -consolidation.final_settlement() * sinking;
    velocities.fluid =
        velocities.solid + mobility * consolidation.initial_pressure * slope / soil.porosity;
    return velocities;
}

/// Put the layer on the series: pressure, effective stress in balance, velocities of consolidation.
void start_on_series(const Consolidation& consolidation, double T, Particles& particles)
{
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double Z = consolidation.depth_ratio(particles.reference_position.y[p]);
        particles.pore_pressure[p] = consolidation.initial_pressure * terzaghi_pressure_ratio(Z, T);
        particles.stress.yy[p] = particles.pore_pressure[p] - consolidation.load;
        const Velocities here = velocities_on_series(consolidation, Z, T);
        const Velocities above = velocities_on_series(consolidation, Z - small, T);
        const Velocities below = velocities_on_series(consolidation, Z + small, T);
        const double apart = 2.0 * small * consolidation.layer.height();
        particles.velocity_solid.y[p] = here.solid;
        particles.velocity_fluid.y[p] = here.fluid;
        particles.velocity_gradient_solid.yy[p] = (above.solid - below.solid) / apart;
        particles.velocity_gradient_fluid.yy[p] = (above.fluid - below.fluid) / apart;
    }
}

std::vector<StudyError> measure(const Problem& problem, const Consolidation& consolidation, double start,
                                State state)
{
    constexpr std::array<std::pair<double, const char*>, 4> time_factors = {
        {{0.02, "0.02"}, {0.1, "0.1"}, {0.5, "0.5"}, {1.0, "1"}}};
    const double p0 = consolidation.initial_pressure;
    const Particles& particles = state.particles;
    std::vector<StudyError> pressures, settlements;
    for (const auto& [T, text] : time_factors) {
        run(problem, consolidation.duration(T - start), {}, state);
        const double pressure = root_mean_square(particles, [&, T = T](std::size_t p) {
            const double Z = consolidation.depth_ratio(particles.reference_position.y[p]);
            return particles.pore_pressure[p] / p0 - terzaghi_pressure_ratio(Z, T);
        });
        const std::size_t top = highest_particle(particles);
        const double Z = consolidation.depth_ratio(particles.reference_position.y[top]);
        const double sunk = particles.reference_position.y[top] - particles.position.y[top];
        const double exact = terzaghi_settlement_degree(Z, T) -
                             (start > 0.0 ? terzaghi_settlement_degree(Z, start) : 0.0);
        pressures.push_back({std::string("pressure at T = ") + text, "L2 / load", pressure});
        settlements.push_back({std::string("settlement at T = ") + text, "surface / final",
                               std::abs(sunk / consolidation.final_settlement() - exact)});
    }
    pressures.insert(pressures.end(), settlements.begin(), settlements.end());
    return pressures;
}

} // namespace

std::vector<StudyError> terzaghi_study(const Problem& problem, State state)
{
    const Consolidation consolidation = read_consolidation(problem, state);
    for (double& stress : state.particles.stress.yy) {
        stress = consolidation.initial_pressure - consolidation.load;
    }
    return measure(problem, consolidation, 0.0, std::move(state));
}

std::vector<StudyError> terzaghi_quasi_static_study(const Problem& problem, State state)
{
    constexpr double start = 0.01; // T
    const Consolidation consolidation = read_consolidation(problem, state);
    start_on_series(consolidation, start, state.particles);
    return measure(problem, consolidation, start, std::move(state));
}

} // namespace quicksand
