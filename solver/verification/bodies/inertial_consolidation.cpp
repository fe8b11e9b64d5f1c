#include "solver/verification/bodies/inertial_consolidation.hpp"

#include "solver/verification/bodies/column_mode.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int most_terms = 1000;

/// The amplitudes of a wave number at a time, from those of the start.
Eigen::Vector4d advance(const SaturatedSoil& soil, double wave_number, double time,
                        const Eigen::Vector4d& start)
{
    const LongitudinalShapes all = longitudinal_shapes(soil, wave_number);
    Eigen::Vector4cd parts = all.duals * start.cast<Complex>();
    for (Eigen::Index k = 0; k < 4; ++k) parts[k] *= std::exp(all.s[k] * time);
    return (all.shapes * parts).real();
}

} // namespace

InertialConsolidation::InertialConsolidation(const SaturatedSoil& soil, double height, double time)
{
    constexpr double negligible = 1e-12; // of p_0
    for (int m = 0; m < most_terms; ++m) {
        const double order = m + 0.5;
        // of the uniform p_0 and of the stress that will carry it
        const double fraction = (m % 2 == 0 ? 2.0 : -2.0) / (order * pi);
        const Eigen::Vector4d now = advance(soil, order * pi / height, time, {0.0, 0.0, fraction, fraction});
        terms_.push_back({order * pi, now[2], now[3]});
        if (std::abs(now[2]) + std::abs(now[3]) < negligible) break;
    }
}

double InertialConsolidation::pressure_ratio(double Z) const
{
    double ratio = 0.0;
    for (const Term& term : terms_) ratio += term.pressure * std::cos(term.wave_number * (1.0 - Z));
    return ratio;
}

double InertialConsolidation::settlement_degree(double Z) const
{
    double degree = 1.0 - Z; // once the grains carry all of p_0
    for (const Term& term : terms_)
        degree -= term.stress * std::sin(term.wave_number * (1.0 - Z)) / term.wave_number;
    return degree;
}

} // namespace quicksand
