#include "solver/verification/studies/permeability_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/column_mode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

struct Decay {
    double rate_error = 0.0;     // relative [-]
    double pressure_error = 0.0; // L2 / p_0 [-]
};

Decay measure_decay(Problem problem, State state, double conductivity, double duration)
{
    for (Material& material : problem.materials) material.hydraulic_conductivity = conductivity;
    const Layer layer = read_layer(problem, state);
    const double xi = 0.5 * std::numbers::pi / layer.height();
    const ColumnMode mode = column_mode(layer, xi, longitudinal_modes(layer.soil, xi).slow);
    start_mode(mode, state.particles);
    const Complex before = measure_start(mode, state.particles);
    run(problem, duration, {}, state);
    const Complex after = measure_mode(problem, mode, state);
    Decay decay;
    decay.rate_error = std::abs(measured_frequency(mode, before, after, duration) / mode.s - 1.0);
    const double left = (mode.shape[3] * std::exp(mode.s * duration)).real();
    decay.pressure_error = root_mean_square(state.particles, [&](std::size_t p) {
        const double height = state.particles.reference_position.y[p] - layer.base;
        return state.particles.pore_pressure[p] - left * std::cos(xi * height);
    });
    return decay;
}

} // namespace

std::vector<StudyError> permeability_study(const Problem& problem, State state)
{
    constexpr std::array<std::pair<double, const char*>, 6> conductivities = {
        {{1e-2, "1e-2"}, {1e-3, "1e-3"}, {1e-4, "1e-4"}, {1e-5, "1e-5"}, {1e-6, "1e-6"}, {1e-7, "1e-7"}}};
    Layer layer = read_layer(problem, state);
    if (is_closed(problem, layer.top)) {
        throw InputError("the verification needs a column with a free and drained top");
    }
    layer.soil.hydraulic_conductivity = conductivities.front().first;
    // long enough for waves of the start's errors to average out as well
    constexpr double wave_periods = 4.0;
    const double H = layer.height(), wave_speed = undragged_speeds(layer.soil).fast;
    const double duration =
        std::max(0.1 * H * H / layer.soil.consolidation_coefficient(), wave_periods * 4.0 * H / wave_speed);
    std::vector<StudyError> errors;
    double largest = 0.0;
    for (const auto& [conductivity, text] : conductivities) {
        const Decay decay = measure_decay(problem, state, conductivity, duration);
        errors.push_back({std::string("decay at k = ") + text, "relative", decay.rate_error});
        largest = std::max(largest, decay.pressure_error);
    }
    errors.push_back({"pressure, any k", "L2 / largest", largest});
    return errors;
}

} // namespace quicksand
