#include "solver/verification/studies/periodic_column_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/periodic_column.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

constexpr int samples_of_period = 64; // of a period
constexpr int most_periods = 200;     // until the motion has become periodic
constexpr double settled = 1e-4; // largest change of an amplitude from period to period, of the largest [-]

/// Complex amplitudes of a field at every particle, over its lasting number.
using Amplitudes = std::vector<Complex>;

struct PeriodicMotion {
    Amplitudes pressure, displacement; // of e^{i omega t} [Pa], [m]
};

/// The closed form at a height above the base, for q sin(omega t) = Re(-i q e^{i omega t}).
ColumnAmplitude exact_amplitude(const PeriodicColumn& column, double load, double x)
{
    const Complex factor = Complex(0.0, -load);
    const ColumnAmplitude unit = periodic_amplitude(column, x);
    return {factor * unit.displacement_solid, factor * unit.displacement_fluid, factor * unit.pore_pressure};
}

/// Stress of the grains from the displacement's slope, by central differences of the closed form [Pa].
Complex effective_stress(const PeriodicColumn& column, double load, double x)
{
    const double step = 1e-5 * column.height;
    const Complex above = exact_amplitude(column, load, x + step).displacement_solid;
    const Complex below = exact_amplitude(column, load, x - step).displacement_solid;
    return column.soil.constrained_modulus * (above - below) / (2.0 * step);
}

/// Put the particles into the periodic state at t = 0.
void start_periodic(const PeriodicColumn& column, double load, double base, Particles& particles)
{
    const Complex rate(0.0, column.angular_frequency());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles.reference_position.y[p] - base;
        const ColumnAmplitude motion = exact_amplitude(column, load, x);
        particles.velocity_solid.y[p] = (rate * motion.displacement_solid).real();
        particles.velocity_fluid.y[p] = (rate * motion.displacement_fluid).real();
        particles.pore_pressure[p] = motion.pore_pressure.real();
        particles.stress.yy[p] = effective_stress(column, load, x).real();
    }
}

/// Run over the period from t on and take the fields' parts at its frequency.
PeriodicMotion measure_period(const Problem& problem, const PeriodicColumn& column, State& state)
{
    const double omega = column.angular_frequency(), period = 2.0 * std::numbers::pi / omega;
    const double start = state.time;
    PeriodicMotion motion;
    motion.pressure.resize(state.particles.size());
    motion.displacement.resize(state.particles.size());
    for (int k = 1; k <= samples_of_period; ++k) {
        run(problem, start + k * period / samples_of_period, {}, state);
        const Complex weight = 2.0 / samples_of_period * std::polar(1.0, -omega * state.time);
        const Particles& particles = state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const auto i = static_cast<std::size_t>(particles.identifier[p]);
            const double rise = particles.position.y[p] - particles.reference_position.y[p];
            motion.pressure[i] += weight * particles.pore_pressure[p];
            motion.displacement[i] += weight * rise;
        }
    }
    return motion;
}

/// Largest change of an amplitude over the largest amplitude [-].
double change(const Amplitudes& before, const Amplitudes& after)
{
    double apart = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        apart = std::max(apart, std::abs(after[i] - before[i]));
        largest = std::max(largest, std::abs(after[i]));
    }
    return apart / largest;
}

/// The motion once a period repeats the one before: what the start was not exactly has died away.
PeriodicMotion measure_periodic(const Problem& problem, const PeriodicColumn& column, State& state)
{
    PeriodicMotion before = measure_period(problem, column, state);
    for (int period = 1; period < most_periods; ++period) {
        PeriodicMotion motion = measure_period(problem, column, state);
        const double apart = std::max(change(before.pressure, motion.pressure),
                                      change(before.displacement, motion.displacement));
        if (apart < settled) return motion;
        before = std::move(motion);
    }
    return before;
}

void add_amplitude_errors(const std::string& field, const Amplitudes& measured, const Amplitudes& exact,
                          std::vector<StudyError>& errors)
{
    double largest = 0.0, amplitude = 0.0, phase = 0.0;
    for (const Complex& value : exact) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < exact.size(); ++i) {
        amplitude = std::max(amplitude, std::abs(std::abs(measured[i]) - std::abs(exact[i])) / largest);
        if (std::abs(exact[i]) > 0.1 * largest) {
            phase = std::max(phase, std::abs(std::arg(measured[i] / exact[i])));
        }
    }
    errors.push_back({field + " amplitude", "largest / largest", amplitude});
    errors.push_back({field + " phase", "largest / rad", phase});
}

} // namespace

std::vector<StudyError> periodic_column_study(const Problem& problem, State state)
{
    const Layer layer = read_layer(problem, state);
    const SurfaceLoad* load = surface_load(problem, layer.top);
    const SineHistory* sine = load ? std::get_if<SineHistory>(&load->history.shape) : nullptr;
    if (!sine || load->history.ramp_time > 0.0) {
        throw InputError("the verification needs a load on the top with a frequency and no ramp");
    }
    PeriodicColumn column;
    column.soil = layer.soil;
    column.height = layer.height();
    column.frequency = sine->frequency;
    const double q = load->pressure - load->traction.y();
    start_periodic(column, q, layer.base, state.particles);

    PeriodicMotion exact;
    exact.pressure.resize(state.particles.size());
    exact.displacement.resize(state.particles.size());
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const auto i = static_cast<std::size_t>(state.particles.identifier[p]);
        const ColumnAmplitude motion =
            exact_amplitude(column, q, state.particles.reference_position.y[p] - layer.base);
        exact.pressure[i] = motion.pore_pressure;
        exact.displacement[i] = motion.displacement_solid;
    }
    const PeriodicMotion measured = measure_periodic(problem, column, state);
    std::vector<StudyError> errors;
    add_amplitude_errors("pressure", measured.pressure, exact.pressure, errors);
    add_amplitude_errors("displacement", measured.displacement, exact.displacement, errors);
    return errors;
}

} // namespace quicksand
