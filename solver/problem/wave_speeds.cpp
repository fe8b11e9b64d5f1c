#include "solver/problem/wave_speeds.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace quicksand {

WaveSpeeds wave_speeds(const Material& material, const std::optional<Water>& water, double porosity)
{
    const double M = std::visit([](const auto& law) { return constrained_modulus(law); }, material.law);
    return wave_speeds(material, M, water, porosity);
}

WaveSpeeds wave_speeds(const Material& material, double skeleton_modulus, const std::optional<Water>& water,
                       double porosity)
{
    const double n = porosity, M = skeleton_modulus;
    // a law whose stiffness follows the stress has both moduli in proportion
    const double G = std::visit(
        [&](const auto& law) { return shear_modulus(law) * (M / constrained_modulus(law)); }, material.law);
    WaveSpeeds speeds;
    if (!water) {
        const double density = (1.0 - n) * material.grain_density;
        speeds.skeleton = std::sqrt(M / density);
        speeds.shear = std::sqrt(G / density);
        return speeds;
    }
    // drag-free plane waves of (v_s, v_w): c^2 are the eigenvalues of R^-1 K with R = diag(r1, r2) and
    // K = [[M + (1-n)^2 K_w/n, (1-n) K_w], [(1-n) K_w, n K_w]]
    const double r1 = (1.0 - n) * material.grain_density, r2 = n * water->density;
    const double a = (M + (1.0 - n) * (1.0 - n) * water->bulk_modulus / n) / r1;
    const double d = n * water->bulk_modulus / r2;
    const double bc = (1.0 - n) * (1.0 - n) * water->bulk_modulus * water->bulk_modulus / (r1 * r2);
    const double half = 0.5 * (a + d);
    const double root = std::sqrt(0.25 * (a - d) * (a - d) + bc);
    speeds.fast = std::sqrt(half + root);
    speeds.slow = std::sqrt((a * d - bc) / (half + root));
    speeds.undrained = std::sqrt((M + water->bulk_modulus / n) / (r1 + r2));
    speeds.skeleton = std::sqrt(M / (r1 + r2));
    speeds.shear = std::sqrt(G / (r1 + r2));
    return speeds;
}

double fastest_speed(const Problem& problem, const WaveSpeeds& speeds)
{
    switch (water_flow(problem).value_or(WaterFlow::drained)) {
    case WaterFlow::coupled:
        return std::max(speeds.fast, speeds.skeleton); // soil above the phreatic line has the latter alone
    case WaterFlow::undrained:
        return std::max(speeds.undrained, speeds.skeleton);
    case WaterFlow::drained:
        return speeds.skeleton; // of the dry soil where there is no water
    }
    ENSURE(false);
}

} // namespace quicksand
