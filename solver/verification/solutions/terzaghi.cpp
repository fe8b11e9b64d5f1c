#include "solver/verification/solutions/terzaghi.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

using std::numbers::pi;
// Below this time factor the images converge in a few terms, above it the sines do; at the limit both are
// exact to rounding.
constexpr double image_limit = 0.2;
constexpr int images = 12;
constexpr int sines = 41; // odd orders up to this one

/// Integral of erfc from x to infinity.
double integrated_erfc(double x)
{
    return std::exp(-x * x) / std::sqrt(pi) - x * std::erfc(x);
}

} // namespace

double terzaghi_pressure_ratio(double Z, double T)
{
    if (T <= 0.0) return Z > 0.0 ? 1.0 : 0.0;
    if (T < image_limit) {
        double ratio = 1.0, sign = 1.0;
        const double reach = 2.0 * std::sqrt(T);
        for (int i = 0; i < images; ++i, sign = -sign)
            ratio -= sign * (std::erfc((2 * i + Z) / reach) + std::erfc((2 * i + 2 - Z) / reach));
        return ratio;
    }
    double ratio = 0.0;
    for (int m = 1; m <= sines; m += 2) {
        const double lambda = 0.5 * m * pi;
        ratio += 2.0 / lambda * std::sin(lambda * Z) * std::exp(-lambda * lambda * T);
    }
    return ratio;
}

double terzaghi_settlement_degree(double Z, double T)
{
    if (T <= 0.0) return 0.0;
    if (T < image_limit) {
        double degree = 0.0, sign = 1.0;
        const double reach = 2.0 * std::sqrt(T);
        for (int i = 0; i < images; ++i, sign = -sign) {
            degree += sign * reach *
                      (integrated_erfc((2 * i + Z) / reach) - integrated_erfc((2 * i + 2 - Z) / reach));
        }
        return degree;
    }
    double degree = 1.0 - Z;
    for (int m = 1; m <= sines; m += 2) {
        const double lambda = 0.5 * m * pi;
        degree -= 2.0 / (lambda * lambda) * std::cos(lambda * Z) * std::exp(-lambda * lambda * T);
    }
    return degree;
}

double time_factor(const SaturatedSoil& soil, double height, double time)
{
    return soil.consolidation_coefficient() * time / (height * height);
}

} // namespace quicksand
