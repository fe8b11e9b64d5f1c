#include "solver/verification/solutions/transient_column.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

using std::numbers::pi;

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
