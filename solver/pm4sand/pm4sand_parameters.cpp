#include "solver/pm4sand/pm4sand_parameters.hpp"

#include "solver/base/failure.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

void fill(double& parameter, double value)
{
    if (std::isnan(parameter)) parameter = value;
}

/// c_eps: 0.5 in loose sand, 0.2 in dense sand; the limits of 0.55 and 0.75 are those of [CA19], which differ
/// from the report's and match its authors' program.
double strain_accumulation_at(double relative_density)
{
    return std::clamp(0.5 - 1.5 * (relative_density - 0.55), 0.2, 0.5);
}

/// hpo by density.
struct CalibratedRate {
    double density, rate; // [-]
};
using RateTable = std::array<CalibratedRate, 8>;

double interpolated(const RateTable& table, double density)
{
    if (density <= table.front().density) return table.front().rate;
    for (std::size_t k = 1; k < table.size(); ++k) {
        const CalibratedRate &below = table[k - 1], &above = table[k];
        if (density > above.density) continue;
        const double part = (density - below.density) / (above.density - below.density);
        return below.rate + part * (above.rate - below.rate);
    }
    return table.back().rate;
}

/// Each of density and blow count by the other.
void fill_density(Pm4Sand& law)
{
    ENSURE(std::isfinite(law.relative_density) || std::isfinite(law.n1_60));
    fill(law.relative_density, std::sqrt(law.n1_60 / blow_count(1.0)));
    fill(law.n1_60, blow_count(law.relative_density));
}

} // namespace

double shear_coefficient_at(double n1_60)
{
    return 167.0 * std::sqrt(n1_60 + 2.5);
}

double contraction_rate_at(double relative_density)
{
    constexpr RateTable table = {{{0.25, 0.58},
                                  {0.35, 0.56},
                                  {0.45, 0.49},
                                  {0.55, 0.43},
                                  {0.65, 0.41},
                                  {0.70, 0.45},
                                  {0.75, 0.72},
                                  {0.80, 2.9}}};
    return interpolated(table, relative_density);
}

Pm4Sand calibrated_pm4sand()
{
    Pm4Sand law;
    law.bounding_exponent = not_given;
    law.reconsolidation_slope = not_given;
    law.liquefied_conductivity = 5.0;
    law.yield_radius = 0.005;
    return law;
}

Pm4Sand complete_calibrated(Pm4Sand law)
{
    constexpr RateTable rates = {{{0.25, 0.537},
                                  {0.35, 0.400},
                                  {0.45, 0.330},
                                  {0.55, 0.275},
                                  {0.65, 0.249},
                                  {0.70, 0.263},
                                  {0.75, 0.40},
                                  {0.80, 1.6}}};
    fill_density(law);
    fill(law.modulus_ratio, std::max(0.3, law.relative_density + 0.11));
    fill(law.bounding_exponent, std::clamp(0.8 - 1.5 * (law.relative_density - 0.35), 0.5, 0.8));
    fill(law.contraction_rate, interpolated(rates, law.relative_density));
    fill(law.reconsolidation_slope, 1.5 * std::exp(-2.5 * law.relative_density));
    return complete(law);
}

Pm4Sand complete(Pm4Sand law)
{
    fill_density(law);
    const double density = law.relative_density;
    fill(law.shear_coefficient, shear_coefficient_at(law.n1_60));
    fill(law.contraction_rate, contraction_rate_at(density));
    fill(law.modulus_ratio, std::max(0.3, 0.5 * (0.25 + density)));
    fill(law.strain_accumulation, strain_accumulation_at(density));
    fill(law.rotated_dilatancy, std::min(10.0, 5.0 + 25.0 * (density - 0.35)));
    fill(law.static_shear_factor, std::clamp(5.0 + 220.0 * std::pow(density - 0.26, 3.0), 4.0, 35.0));
    fill(law.sedimentation_floor, std::min(0.99, 0.03 * std::exp(2.6 * density)));
    law.critical_ratio = 2.0 * std::sin(law.constant_volume_friction_deg * std::numbers::pi / 180.0);
    const double nu = law.drained_poisson_ratio;
    law.bulk_over_shear = 2.0 * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
    return law;
}

} // namespace quicksand
