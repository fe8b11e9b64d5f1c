#include "solver/verification/bodies/column_mode.hpp"

#include "solver/run/simulation.hpp"
#include "solver/verification/solutions/eigenmodes.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace quicksand {

namespace {

/// sum V f(y) g(y) / sum V g(y)^2: amplitude of the shape g in the values f.
template <class Shape>
double project(const ColumnMode& mode, const Particles& particles, const Scalars& values, Shape&& shape)
{
    double sum = 0.0, norm = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double g = shape(mode.wave_number * (particles.reference_position.y[p] - mode.base));
        sum += particles.volume[p] * values[p] * g;
        norm += particles.volume[p] * g * g;
    }
    return sum / norm;
}

/// Amplitudes a, b, c, d in the present state.
Eigen::Vector4d project(const ColumnMode& mode, const Particles& particles)
{
    const auto sine = [](double phase) { return std::sin(phase); };
    const auto cosine = [](double phase) { return std::cos(phase); };
    return {project(mode, particles, particles.velocity_solid.y, sine),
            project(mode, particles, particles.velocity_fluid.y, sine),
            project(mode, particles, particles.stress.yy, cosine),
            project(mode, particles, particles.pore_pressure, cosine)};
}

/// The same where velocities stand half a step before the stresses: their mean with those of one step more.
Eigen::Vector4d measure_amplitudes(const Problem& problem, const ColumnMode& mode, State state)
{
    Eigen::Vector4d y = project(mode, state.particles);
    run(problem, state.time + state.last_step, {}, state);
    y.head<2>() = 0.5 * (y + project(mode, state.particles)).head<2>();
    return y;
}

template <class Values>
Eigen::Index nearest_to(Complex value, const Values& values)
{
    Eigen::Index nearest = 0;
    (values.array() - value).abs().minCoeff(&nearest);
    return nearest;
}

Complex part_of_mode(const ColumnMode& mode, const Eigen::Vector4d& amplitudes)
{
    return mode.dual.cwiseProduct(amplitudes.cast<Complex>()).sum();
}

} // namespace

Eigen::Matrix4d longitudinal_rates(const SaturatedSoil& soil, double wave_number)
{
    const double xi = wave_number, n = soil.porosity, C = soil.drag(), M = soil.constrained_modulus;
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid();
    Eigen::Matrix4d A;
    A << -C / r1, C / r1, -xi / r1, (1.0 - n) * xi / r1, //
        C / r2, -C / r2, 0.0, n * xi / r2,               //
        M * xi, 0.0, 0.0, 0.0,                           //
        -soil.storage_modulus() * xi * (1.0 - n), -soil.storage_modulus() * xi * n, 0.0, 0.0;
    return A;
}

LongitudinalShapes longitudinal_shapes(const SaturatedSoil& soil, double wave_number)
{
    // momentum in units of stress makes the matrix well scaled
    const double impedance = std::sqrt(soil.density() * soil.undrained_modulus());
    const Eigen::Vector4d scale(1.0 / impedance, 1.0 / impedance, 1.0, 1.0);
    const Eigen::Matrix4d scaled =
        scale.cwiseInverse().asDiagonal() * longitudinal_rates(soil, wave_number) * scale.asDiagonal();
    const Eigenmodes modes = eigenmodes(scaled.cast<Complex>());
    return {modes.values, scale.asDiagonal() * modes.vectors, modes.duals * scale.cwiseInverse().asDiagonal(),
            scale};
}

ColumnMode column_mode(const Layer& layer, double wave_number, Complex s)
{
    const LongitudinalShapes all = longitudinal_shapes(layer.soil, wave_number);
    const Eigen::Index nearest = nearest_to(s, all.s);
    const Complex pressure = all.shapes(3, nearest);
    ColumnMode mode;
    mode.base = layer.base;
    mode.wave_number = wave_number;
    mode.s = all.s[nearest];
    mode.shape = all.shapes.col(nearest) / pressure;
    mode.dual = all.duals.row(nearest).transpose() * pressure;
    return mode;
}

void start_mode(const ColumnMode& mode, Particles& particles)
{
    start_amplitudes(mode, mode.shape.real(), particles);
}

void start_amplitudes(const ColumnMode& mode, const Eigen::Vector4d& y, Particles& particles)
{
    const double xi = mode.wave_number;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double phase = xi * (particles.reference_position.y[p] - mode.base);
        const double sine = std::sin(phase), cosine = std::cos(phase);
        particles.velocity_solid.y[p] = y[0] * sine;
        particles.velocity_fluid.y[p] = y[1] * sine;
        particles.affine_velocity_solid.yy[p] = xi * y[0] * cosine;
        particles.affine_velocity_fluid.yy[p] = xi * y[1] * cosine;
        particles.stress.yy[p] = y[2] * cosine;
        particles.pore_pressure[p] = y[3] * cosine;
    }
}

Complex measure_start(const ColumnMode& mode, const Particles& particles)
{
    return part_of_mode(mode, project(mode, particles));
}

Complex measure_mode(const Problem& problem, const ColumnMode& mode, State state)
{
    return part_of_mode(mode, measure_amplitudes(problem, mode, std::move(state)));
}

Complex propagated_frequency(const Problem& problem, const Layer& layer, const ColumnMode& mode,
                             const State& state, double duration)
{
    const LongitudinalShapes all = longitudinal_shapes(layer.soil, mode.wave_number);
    // changes, for the stress that varies within a cell, which the grid does not see, stays as it was
    constexpr std::array<double, 3> fractions = {0.2, 0.6, 1.0}; // of the duration
    Eigen::Matrix4d before, after;
    for (int k = 0; k < 4; ++k) {
        State alone = state;
        start_amplitudes(mode, all.scale[k] * Eigen::Vector4d::Unit(k), alone.particles);
        std::array<Eigen::Vector4d, 3> amplitudes;
        for (std::size_t j = 0; j < 3; ++j) {
            run(problem, state.time + fractions[j] * duration, {}, alone);
            amplitudes[j] = measure_amplitudes(problem, mode, alone) / all.scale[k];
        }
        before.col(k) = amplitudes[1] - amplitudes[0];
        after.col(k) = amplitudes[2] - amplitudes[1];
    }
    constexpr double dead = -15.0; // exponent of a mode of which nothing can be measured
    std::vector<Eigen::Index> alive;
    for (Eigen::Index k = 0; k < 4; ++k) {
        if (all.s[k].real() * fractions[0] * duration > dead) alive.push_back(k);
    }
    const Eigen::MatrixXcd duals = all.duals(alive, Eigen::all), shapes = all.shapes(Eigen::all, alive);
    const auto parts = [&](const Eigen::MatrixXcd& amplitudes) -> Eigen::MatrixXcd {
        return duals * amplitudes * shapes;
    };
    const Eigen::MatrixXcd propagator = parts(after.cast<Complex>()) * inverse(parts(before.cast<Complex>()));
    const Eigen::VectorXcd factors = eigenvalues(propagator);
    const double elapsed = (fractions[2] - fractions[1]) * duration;
    return measured_frequency(mode, 1.0, factors[nearest_to(std::exp(mode.s * elapsed), factors)], elapsed);
}

Complex measured_frequency(const ColumnMode& mode, Complex before, Complex after, double duration)
{
    const Complex growth = std::log(after / before * std::exp(-mode.s * duration));
    return mode.s + growth / duration;
}

} // namespace quicksand
