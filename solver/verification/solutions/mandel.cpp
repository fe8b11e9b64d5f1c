#include "solver/verification/solutions/mandel.hpp"

#include "solver/base/failure.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

using std::numbers::pi;

/// Poisson's ratio of a constrained and a shear modulus.
double poisson_ratio_of(double M, double G)
{
    return 0.5 * (M - 2.0 * G) / (M - G);
}

/// Root of sin(alpha) = slope alpha cos(alpha) between i pi and i pi + pi/2, for slope > 1.
double root_of(double slope, int i)
{
    const auto residual = [slope, i](double above) {
        // sine and cosine of the distance from i pi, whose sign does not alternate
        return std::sin(above) - slope * (i * pi + above) * std::cos(above);
    };
    double low = i == 0 ? 1e-3 * std::sqrt(1.0 - 1.0 / slope) : 0.0, high = 0.5 * pi;
    for (int bisection = 0; bisection < 60; ++bisection) {
        const double middle = 0.5 * (low + high);
        (residual(middle) < 0.0 ? low : high) = middle;
    }
    return i * pi + 0.5 * (low + high);
}

} // namespace

double MandelSlab::poisson_ratio() const
{
    return poisson_ratio_of(soil.constrained_modulus, soil.shear_modulus);
}

double MandelSlab::undrained_poisson_ratio() const
{
    return poisson_ratio_of(soil.undrained_modulus(), soil.shear_modulus);
}

double MandelSlab::initial_pressure() const
{
    const double bulk_modulus = soil.constrained_modulus - 4.0 / 3.0 * soil.shear_modulus;
    const double skempton = soil.storage_modulus() / (bulk_modulus + soil.storage_modulus());
    return force * skempton * (1.0 + undrained_poisson_ratio()) / (3.0 * half_width);
}

MandelState::MandelState(const MandelSlab& slab, double T) : slab_(slab)
{
    ENSURE(T > 0.0); // the series has no end at the start
    const double nu = slab.poisson_ratio(), nu_u = slab.undrained_poisson_ratio();
    const double slope = (1.0 - nu) / (nu_u - nu);
    for (int i = 0;; ++i) {
        const double root = root_of(slope, i);
        const double decay = std::exp(-root * root * T);
        terms_.push_back({root, decay / (root - std::sin(root) * std::cos(root))});
        if (decay < 1e-18) break;
    }
}

double MandelState::pore_pressure(double x) const
{
    double sum = 0.0;
    for (const auto& [root, amplitude] : terms_)
        sum += amplitude * std::sin(root) * (std::cos(root * x / slab_.half_width) - std::cos(root));
    return 2.0 * slab_.initial_pressure() * sum;
}

double MandelState::vertical_stress(double x) const
{
    const double nu = slab_.poisson_ratio(), nu_u = slab_.undrained_poisson_ratio();
    double sum = 0.0;
    for (const auto& [root, amplitude] : terms_) {
        const double bulge = (nu_u - nu) / (1.0 - nu) * std::cos(root * x / slab_.half_width);
        sum += amplitude * std::sin(root) * (std::cos(root) - bulge);
    }
    return slab_.force / slab_.half_width * (2.0 * sum - 1.0);
}

double MandelState::displacement_x(double x) const
{
    const double nu = slab_.poisson_ratio(), nu_u = slab_.undrained_poisson_ratio();
    const double ratio = x / slab_.half_width;
    double sum = 0.5 * nu * ratio;
    for (const auto& [root, amplitude] : terms_) {
        sum += amplitude * std::cos(root) * (std::sin(root * ratio) - nu_u * std::sin(root) * ratio);
    }
    return slab_.force / slab_.soil.shear_modulus * sum;
}

double MandelState::displacement_y(double y) const
{
    const double nu = slab_.poisson_ratio(), nu_u = slab_.undrained_poisson_ratio();
    double sum = -0.5 * (1.0 - nu);
    for (const auto& [root, amplitude] : terms_)
        sum += amplitude * (1.0 - nu_u) * std::sin(root) * std::cos(root);
    return slab_.force / slab_.soil.shear_modulus * sum * y / slab_.half_width;
}

} // namespace quicksand
