#include "solver/verification/studies/shear_beam_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/shear_beam.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace quicksand {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int samples_per_period = 40;

/// Takes a number out of the state at equal times.
class Sampler : public Observer {
public:
    using Quantity = std::function<double(const Particles&)>;
    Sampler(double interval, Quantity quantity) : interval_(interval), quantity_(std::move(quantity)) {}
    double next_time() const override { return static_cast<double>(values.size()) * interval_; }
    void observe(const Problem&, const State& state, const StepReport&) override
    {
        times.push_back(state.time);
        values.push_back(quantity_(state.particles));
    }
    std::vector<double> times, values;

private:
    double interval_; // [s]
    Quantity quantity_;
};

/// Horizontal motion of a column: velocities of grains and water, and the shear stress, over the height.
struct ShearState {
    std::function<double(double)> solid, fluid, stress; // of y above the base [m/s], [m/s], [Pa]
};

void start(const ShearState& motion, double base, double height, Particles& particles)
{
    const double step = 1e-6 * height;
    const auto slope = [&](const std::function<double(double)>& f, double y) {
        return (f(y + step) - f(y - step)) / (2.0 * step);
    };
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.reference_position.y[p] - base;
        particles.velocity_solid.x[p] = motion.solid(y);
        particles.velocity_fluid.x[p] = motion.fluid(y);
        particles.affine_velocity_solid.xy[p] = slope(motion.solid, y);
        particles.affine_velocity_fluid.xy[p] = slope(motion.fluid, y);
        particles.stress.xy[p] = motion.stress(y);
    }
}

/// Cycles per time between the first and the last upward crossing of zero [Hz].
double measured_frequency(const Sampler& sampler)
{
    std::vector<double> crossings;
    for (std::size_t k = 1; k < sampler.values.size(); ++k) {
        const double before = sampler.values[k - 1], after = sampler.values[k];
        if (!(before < 0.0 && after >= 0.0)) continue;
        const double fraction = -before / (after - before);
        crossings.push_back(sampler.times[k - 1] + fraction * (sampler.times[k] - sampler.times[k - 1]));
    }
    if (crossings.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
}

StudyError resonance(const Problem& given, const Layer& layer, int number, State state)
{
    const double xi = (2.0 * number - 1.0) * pi / (2.0 * layer.height());
    const Complex s = shear_modes(layer.soil, xi).shear;
    const Complex water = shear_fluid_ratio(layer.soil, s);
    const double G = layer.soil.shear_modulus;
    constexpr double speed = 1e-6; // small enough for a linear problem [m/s]
    start({[&](double y) { return speed * std::sin(xi * y); },
           [&](double y) { return speed * water.real() * std::sin(xi * y); },
           [&](double y) { return speed * (1.0 / s).real() * G * xi * std::cos(xi * y); }},
          layer.base, layer.height(), state.particles);
    Problem problem = given;
    problem.base_motion = NoMotion{};
    const double period = 2.0 * pi / s.imag();
    Sampler sampler(period / samples_per_period, [&](const Particles& particles) {
        double sum = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            sum += particles.volume[p] * particles.velocity_solid.x[p] *
                   std::sin(xi * (particles.reference_position.y[p] - layer.base));
        }
        return sum;
    });
    run(problem, state.time + 4.0 * period, {&sampler}, state);
    return {"resonance " + std::to_string(number), "relative",
            std::abs(measured_frequency(sampler) * period - 1.0)};
}

StudyError transfer(const Problem& given, const Layer& layer, double ratio, double frequency, State state)
{
    const ShearBeam beam{layer.soil, layer.height(), 0.0};
    const double omega = 2.0 * pi * frequency, amplitude = 1e-6; // of the base's acceleration [m/s2]
    const Complex i(0.0, 1.0), water = shear_fluid_ratio(layer.soil, i * omega);
    const double base = -amplitude / (omega * omega); // displacement of the base, Im(base e^{i omega t}) [m]
    const auto T = [&](double y) { return shear_transfer(beam, y, frequency); };
    const double step = 1e-6 * beam.height;
    start({[&](double y) { return (i * omega * base * (T(y) - 1.0)).imag(); },
           [&](double y) { return (i * omega * base * (water * T(y) - 1.0)).imag(); },
           [&](double y) {
               return (layer.soil.shear_modulus * base * (T(y + step) - T(y - step)) / (2.0 * step)).imag();
           }},
          layer.base, beam.height, state.particles);
    Problem problem = given;
    problem.base_motion = SineMotion{amplitude, frequency, std::numeric_limits<double>::infinity(), 0.0};

    const std::int32_t top = state.particles.identifier[highest_particle(state.particles)];
    double y_top = 0.0;
    Sampler sampler(1.0 / (frequency * samples_per_period), [&](const Particles& particles) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            if (particles.identifier[p] != top) continue;
            y_top = particles.reference_position.y[p] - layer.base;
            return particles.position.x[p] - particles.reference_position.x[p];
        }
        ENSURE(false);
    });
    run(problem, 2.0 / frequency, {&sampler}, state);
    Complex mean = 0.0; // of u e^{-i omega t} over the second period
    for (int k = samples_per_period; k < 2 * samples_per_period; ++k) {
        const auto sample = static_cast<std::size_t>(k);
        mean += sampler.values[sample] * std::exp(-i * omega * sampler.times[sample]) /
                static_cast<double>(samples_per_period);
    }
    const Complex measured = 2.0 * i * mean / base + 1.0, exact = T(y_top);
    return {"surface over base at " + std::to_string(ratio).substr(0, 3) + " of the resonance",
            "complex, relative", std::abs(measured - exact) / std::abs(exact)};
}

} // namespace

std::vector<StudyError> shear_beam_study(const Problem& problem, State state)
{
    const Layer layer = read_layer(problem, state);
    if (!problem.tied_sides) throw InputError("the verification needs a layer between tied sides");
    const double first = shear_modes(layer.soil, pi / (2.0 * layer.height())).shear.imag() / (2.0 * pi);
    std::vector<StudyError> errors;
    for (const int number : {1, 2}) errors.push_back(resonance(problem, layer, number, state));
    for (const double ratio : {0.5, 1.5, 2.5})
        errors.push_back(transfer(problem, layer, ratio, ratio * first, state));
    return errors;
}

} // namespace quicksand
