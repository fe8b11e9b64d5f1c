#include "solver/verification/column_mode.hpp"

#include "solver/simulation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

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

ColumnMode column_mode(const Layer& layer, double wave_number, Complex s)
{
    // momentum in units of stress makes the matrix well scaled
    const Eigen::Matrix4d A = longitudinal_rates(layer.soil, wave_number);
    const double impedance = std::sqrt(layer.soil.density() * layer.soil.undrained_modulus());
    const Eigen::Vector4d scale(impedance, impedance, 1.0, 1.0);
    const Eigen::Matrix4d scaled = scale.asDiagonal() * A * scale.cwiseInverse().asDiagonal();
    const Eigen::EigenSolver<Eigen::Matrix4d> solver(scaled);
    Eigen::Index nearest = 0;
    for (Eigen::Index k = 1; k < 4; ++k) {
        if (std::abs(solver.eigenvalues()[k] - s) < std::abs(solver.eigenvalues()[nearest] - s)) nearest = k;
    }
    const Eigen::Matrix4cd shapes = scale.cwiseInverse().asDiagonal() * solver.eigenvectors();
    const Complex pressure = shapes(3, nearest);
    ColumnMode mode;
    mode.base = layer.base;
    mode.wave_number = wave_number;
    mode.s = solver.eigenvalues()[nearest];
    mode.shape = shapes.col(nearest) / pressure;
    mode.dual = shapes.inverse().row(nearest).transpose() * pressure;
    return mode;
}

void start_mode(const ColumnMode& mode, Particles& particles)
{
    const double xi = mode.wave_number;
    const Eigen::Vector4d y = mode.shape.real();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double phase = xi * (particles.reference_position.y[p] - mode.base);
        const double sine = std::sin(phase), cosine = std::cos(phase);
        particles.velocity_solid.y[p] = y[0] * sine;
        particles.velocity_fluid.y[p] = y[1] * sine;
        particles.velocity_gradient_solid.yy[p] = xi * y[0] * cosine;
        particles.velocity_gradient_fluid.yy[p] = xi * y[1] * cosine;
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
    Eigen::Vector4d y = project(mode, state.particles);
    run(problem, state.time + state.last_step, {}, state);
    y.head<2>() = 0.5 * (y + project(mode, state.particles)).head<2>();
    return part_of_mode(mode, y);
}

Complex measured_frequency(const ColumnMode& mode, Complex before, Complex after, double duration)
{
    const Complex growth = std::log(after / before * std::exp(-mode.s * duration));
    return mode.s + growth / duration;
}

} // namespace quicksand
