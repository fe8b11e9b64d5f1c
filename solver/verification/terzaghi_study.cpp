#include "solver/verification/terzaghi_study.hpp"

#include "solver/failure.hpp"
#include "solver/simulation.hpp"
#include "solver/verification/inertial_consolidation.hpp"
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
    consolidation.load = steady_load_on(problem, consolidation.layer.top);
    return consolidation;
}

std::vector<StudyError> measure(const Problem& problem, const Consolidation& consolidation, State state)
{
    constexpr std::array<std::pair<double, const char*>, 4> time_factors = {
        {{0.02, "0.02"}, {0.1, "0.1"}, {0.5, "0.5"}, {1.0, "1"}}};
    const Layer& layer = consolidation.layer;
    const double p0 = consolidation.initial_pressure;
    const Particles& particles = state.particles;
    const auto depth = [&](std::size_t p) {
        return consolidation.depth_ratio(particles.reference_position.y[p]);
    };
    std::vector<StudyError> pressures, with_inertia, settlements;
    for (const auto& [T, text] : time_factors) {
        run(problem, consolidation.duration(T), {}, state);
        const InertialConsolidation inertial(layer.soil, layer.height(), state.time);
        const double pressure = root_mean_square(particles, [&, T = T](std::size_t p) {
            return particles.pore_pressure[p] / p0 - terzaghi_pressure_ratio(depth(p), T);
        });
        const double inertial_pressure = root_mean_square(particles, [&](std::size_t p) {
            return particles.pore_pressure[p] / p0 - inertial.pressure_ratio(depth(p));
        });
        const std::size_t top = highest_particle(particles);
        const double sunk = particles.reference_position.y[top] - particles.position.y[top];
        const double exact = terzaghi_settlement_degree(depth(top), T);
        const std::string at = std::string(" at T = ") + text;
        pressures.push_back({"pressure" + at, "L2 / load", pressure});
        with_inertia.push_back({"pressure with inertia" + at, "L2 / load", inertial_pressure});
        settlements.push_back({"settlement" + at, "surface / final",
                               std::abs(sunk / consolidation.final_settlement() - exact)});
    }
    pressures.insert(pressures.end(), with_inertia.begin(), with_inertia.end());
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
    return measure(problem, consolidation, std::move(state));
}

} // namespace quicksand
