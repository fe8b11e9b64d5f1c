#include "solver/verification/studies/anura_column_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/inertial_consolidation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/terzaghi.hpp"

#include <array>
#include <cmath>
#include <string>

namespace quicksand {

std::vector<StudyError> anura_column_study(const Problem& problem, State state)
{
    constexpr std::array<std::pair<double, const char*>, 5> times = {
        {{0.049, "0.049 s"}, {0.098, "0.098 s"}, {0.196, "0.196 s"}, {0.49, "0.49 s"}, {0.98, "0.98 s"}}};
    const Layer layer = read_layer(problem, state);
    const Particles& particles = state.particles;
    const double q = steady_load_on(problem, layer.top), M = layer.soil.constrained_modulus;
    if (!(q > 0.0) || std::abs(particles.pore_pressure.front() - q) > 1e-9 * q) {
        throw InputError("the verification needs a load on the top that initial.excess_pore_pressure equals");
    }
    std::vector<StudyError> pressures, with_inertia, settlements;
    const auto depth = [&](std::size_t p) {
        return (layer.top - particles.reference_position.y[p]) / layer.height();
    };
    for (const auto& [time, text] : times) {
        run(problem, time, {}, state);
        const double T = time_factor(layer.soil, layer.height(), time);
        const InertialConsolidation inertial(layer.soil, layer.height(), time);
        const double pressure = root_mean_square(particles, [&](std::size_t p) {
            return particles.pore_pressure[p] / q - terzaghi_pressure_ratio(depth(p), T);
        });
        const double inertial_pressure = root_mean_square(particles, [&](std::size_t p) {
            return particles.pore_pressure[p] / q - inertial.pressure_ratio(depth(p));
        });
        const std::size_t top = highest_particle(particles);
        const double sunk = particles.reference_position.y[top] - particles.position.y[top];
        const double final_settlement = q * layer.height() / M;
        const auto add_settlement = [&](const std::string& quantity, double degree) {
            settlements.push_back(
                {quantity, "surface / exact", std::abs(sunk / (final_settlement * degree) - 1.0)});
        };
        const std::string at = std::string(" at ") + text;
        pressures.push_back({"pressure" + at, "L2 / load", pressure});
        with_inertia.push_back({"pressure with inertia" + at, "L2 / load", inertial_pressure});
        add_settlement("settlement" + at, terzaghi_settlement_degree(depth(top), T));
        add_settlement("settlement with inertia" + at, inertial.settlement_degree(depth(top)));
    }
    pressures.insert(pressures.end(), with_inertia.begin(), with_inertia.end());
    pressures.insert(pressures.end(), settlements.begin(), settlements.end());
    return pressures;
}

} // namespace quicksand
