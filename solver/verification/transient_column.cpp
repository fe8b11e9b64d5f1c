#include "solver/verification/transient_column.hpp"

#include "solver/failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

constexpr double pi = std::numbers::pi;

/// e^{-x} I_0(x) for x >= 0: the power series, and the asymptotic one where it is exact to rounding.
double scaled_bessel_i0(double x)
{
    double term = 1.0, sum = 1.0;
    if (x < 30.0) {
        for (int k = 1; term > 1e-17 * sum; ++k) {
            term *= 0.25 * x * x / (k * k);
            sum += term;
        }
        return std::exp(-x) * sum;
    }
    for (int k = 1; k <= 20; ++k) {
        term *= (2.0 * k - 1.0) * (2.0 * k - 1.0) / (8.0 * k * x);
        sum += term;
    }
    return sum / std::sqrt(2.0 * pi * x);
}

/// a and b of the wave equation of the half space: u_zz = a u_tt + b u_t.
struct HalfSpace {
    double a, b; // [s2/m2], [s/m2]
};

HalfSpace half_space(const SaturatedSoil& soil)
{
    const double n = soil.porosity, stiffness = soil.constrained_modulus * n * n;
    const double inertia =
        n * n * soil.partial_density_solid() + (1.0 - n) * (1.0 - n) * soil.partial_density_fluid();
    return {inertia / stiffness, soil.drag() / stiffness};
}

/// Integral over an interval by Gauss-Legendre's rule of eight points.
template <class Function>
double gauss_integral(const Function& function, double from, double to)
{
    constexpr std::array<double, 4> point = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                             0.9602898564975363};
    constexpr std::array<double, 4> weight = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0.0;
    for (std::size_t i = 0; i < point.size(); ++i)
        sum += weight[i] * (function(middle - half * point[i]) + function(middle + half * point[i]));
    return half * sum;
}

/// Laplace transform of the ramp of unit height: h(t) + h(t - t_r) with h = [1 - cos(pi t / t_r)] / 2.
Complex ramp_transform(double duration, Complex s)
{
    const double omega = pi / duration;
    return 0.5 * omega * omega * (1.0 + std::exp(-s * duration)) / (s * (s * s + omega * omega));
}

ColumnAmplitude operator*(Complex factor, const ColumnAmplitude& amplitude)
{
    return {factor * amplitude.displacement_solid, factor * amplitude.displacement_fluid,
            factor * amplitude.pore_pressure};
}

} // namespace

double half_space_settlement(const SaturatedSoil& soil, const std::function<double(double)>& load,
                             double depth, double time)
{
    const auto [a, b] = half_space(soil);
    const double arrival = std::sqrt(a) * depth, rate = 0.5 * b / a;
    if (time <= arrival) return 0.0;
    // e^{-rate tau} I_0(rate root) with the growth of I_0 taken into the exponential
    const auto kernel = [&, a = a](double tau) {
        const double root = std::sqrt(std::max(0.0, tau * tau - arrival * arrival));
        const double decay = std::exp(-rate * a * depth * depth / (tau + root));
        return load(time - tau) * decay * scaled_bessel_i0(rate * root);
    };
    // intervals that shrink towards the arrival, where the kernel changes within 1/rate
    constexpr int halvings = 40, pieces = 32;
    double sum = 0.0, to = time - arrival;
    for (int i = 0; i <= halvings; ++i) {
        const double from = i < halvings ? 0.5 * to : 0.0, piece = (to - from) / pieces;
        for (int j = 0; j < pieces; ++j)
            sum += gauss_integral(kernel, arrival + from + j * piece, arrival + from + (j + 1) * piece);
        to = from;
    }
    return sum / (soil.constrained_modulus * std::sqrt(a));
}

double half_space_front_speed(const SaturatedSoil& soil)
{
    return 1.0 / std::sqrt(half_space(soil).a);
}

namespace {

/// Inverse transform of the response to a load with the Laplace transform `load`, which varies over
/// `duration` [s].
template <class Transform>
std::vector<ColumnMotion> invert_response(const SaturatedSoil& soil, double height, double duration,
                                          Transform&& load, double x, const std::vector<double>& times)
{
    std::vector<ColumnMotion> motion(times.size());
    const double latest = times.empty() ? 0.0 : *std::max_element(times.begin(), times.end());
    if (latest <= 0.0) return motion;
    ENSURE(duration > 0.0); // the series of a sudden load does not converge
    // f(t) = e^{ct}/T { F(c)/2 + sum_k Re[F(c + i k pi/T) e^{i k pi t/T}] }; the error is f(t + 2T) e^{-2cT}
    const double T = 2.0 * latest, c = 10.0 / T;
    constexpr double highest = 1000.0 * pi; // frequency times duration where the transform has died out
    const auto terms = static_cast<long>(highest * T / (pi * duration)) + 200;
    std::vector<Complex> turn(times.size(), 1.0);
    for (long k = 0; k <= terms; ++k) {
        const Complex s(c, static_cast<double>(k) * pi / T);
        const ColumnAmplitude F =
            ((k == 0 ? 0.5 : 1.0) * load(s)) * ColumnResponse(soil, height, s).amplitude(x);
        for (std::size_t i = 0; i < times.size(); ++i) {
            motion[i].displacement_solid += std::real(F.displacement_solid * turn[i]);
            motion[i].displacement_fluid += std::real(F.displacement_fluid * turn[i]);
            motion[i].pore_pressure += std::real(F.pore_pressure * turn[i]);
            turn[i] *= std::polar(1.0, pi * times[i] / T);
        }
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double growth = times[i] > 0.0 ? std::exp(c * times[i]) / T : 0.0; // at rest before
        motion[i].displacement_solid *= growth;
        motion[i].displacement_fluid *= growth;
        motion[i].pore_pressure *= growth;
    }
    return motion;
}

} // namespace

std::vector<ColumnMotion> column_motion(const TransientColumn& column, double x,
                                        const std::vector<double>& times)
{
    const auto load = [&](Complex s) { return column.load * ramp_transform(column.ramp_duration, s); };
    return invert_response(column.soil, column.height, column.ramp_duration, load, x, times);
}

std::vector<ColumnMotion> column_motion(const SaturatedSoil& soil, double height, const LoadPolygon& load,
                                        double x, const std::vector<double>& times)
{
    ENSURE(load.times.size() >= 2 && load.times.size() == load.values.size());
    // sum over the kinks of the change of slope times e^{-s t}/s^2; the slope is zero before and after
    const auto transform = [&](Complex s) {
        Complex sum = 0.0;
        double before = 0.0;
        for (std::size_t k = 0; k < load.times.size(); ++k) {
            const bool last = k + 1 == load.times.size();
            const double slope =
                last ? 0.0 : (load.values[k + 1] - load.values[k]) / (load.times[k + 1] - load.times[k]);
            sum += (slope - before) * std::exp(-s * load.times[k]);
            before = slope;
        }
        return sum / (s * s);
    };
    return invert_response(soil, height, load.times.back(), transform, x, times);
}

} // namespace quicksand
