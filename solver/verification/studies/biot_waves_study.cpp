#include "solver/verification/studies/biot_waves_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/column_mode.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

/// Complex frequency of the mode in a run over a period, or over its time of decay where that is shorter: of
/// what has died away nothing can be measured.
Complex measure_frequency(const Problem& problem, const Layer& layer, const ColumnMode& mode,
                          const State& state)
{
    constexpr double decay_times = 3.0; // to a twentieth
    const double duration =
        std::min(2.0 * std::numbers::pi / std::abs(mode.s.imag()), decay_times / std::abs(mode.s.real()));
    return propagated_frequency(problem, layer, mode, state, duration);
}

void add_wave_errors(const char* wave, const ColumnMode& mode, Complex measured,
                     std::vector<StudyError>& errors)
{
    // a wave that drag keeps from travelling has no speed; what is measured is then relative to its decay
    const bool travels = std::abs(mode.s.imag()) > 1e-9 * std::abs(mode.s);
    const double scale = travels ? std::abs(mode.s.imag()) : std::abs(mode.s);
    errors.push_back(
        {std::string(wave) + " wave, speed", "relative", std::abs(measured.imag() - mode.s.imag()) / scale});
    errors.push_back(
        {std::string(wave) + " wave, decay", "relative", std::abs(measured.real() / mode.s.real() - 1.0)});
}

} // namespace

std::vector<StudyError> biot_waves_study(const Problem& problem, State state)
{
    const Layer layer = read_layer(problem, state);
    if (!is_closed(problem, layer.top)) {
        throw InputError("the verification needs a column whose top is fixed and impervious");
    }
    const double xi = 2.0 * std::numbers::pi / layer.height();
    const LongitudinalModes exact = longitudinal_modes(layer.soil, xi);
    std::vector<StudyError> errors;
    for (const auto& [name, s] : {std::pair("fast", exact.fast), std::pair("slow", exact.slow)}) {
        const ColumnMode mode = column_mode(layer, xi, s);
        add_wave_errors(name, mode, measure_frequency(problem, layer, mode, state), errors);
    }
    return errors;
}

} // namespace quicksand
