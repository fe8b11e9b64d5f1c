#include "solver/ubcsand/ubcsand_parameters.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace quicksand {

namespace {

void require(bool holds, const char* name, double value, const char* allowed)
{
    if (holds) return;
    std::ostringstream text;
    text << "UBCSAND: " << name << " = " << value << ", but it must be " << allowed;
    throw InputError(text.str());
}

void require_positive(const char* name, double value)
{
    require(value > 0.0 && std::isfinite(value), name, value, "positive");
}

void require_not_negative(const char* name, double value)
{
    require(value >= 0.0 && std::isfinite(value), name, value, "zero or positive");
}

/// The denominator of the plastic multiplier, G + G^p - eta D K', must stay positive; eta D is at most
/// sin^2(phi_cv)/4. K'/G is monotonic in the stress, so the ends of its range decide.
void require_stable_flow(const UbcSandParameters& m)
{
    const double sin_cv = std::sin(m.constant_volume_friction_deg * std::numbers::pi / 180.0);
    for (const double stress : {m.stress_floor, 100.0 * atmospheric_pressure}) {
        const double exponent = m.elastic_bulk_exponent - m.elastic_shear_exponent;
        const double bulk_ratio = m.elastic_bulk_number / m.elastic_shear_number *
                                  std::pow(stress / atmospheric_pressure, exponent);
        require((bulk_ratio + 1.0 / 3.0) * sin_cv * sin_cv / 4.0 < 0.9, "elastic_bulk_number",
                m.elastic_bulk_number, "the drained stiffness, at most about 10 times elastic_shear_number");
    }
}

} // namespace

double blow_count(double relative_density)
{
    return 46.0 * relative_density * relative_density;
}

UbcSandParameters ubcsand_from_blow_count(double n1_60, std::optional<double> elastic_shear_number,
                                          std::optional<double> constant_volume_friction_deg)
{
    require_positive("n1_60", n1_60);
    const double N = n1_60;
    UbcSandParameters parameters;
    parameters.relative_density = std::sqrt(N / blow_count(1.0));
    parameters.elastic_shear_number = elastic_shear_number.value_or(21.7 * 20.0 * std::cbrt(N));
    parameters.elastic_bulk_number = 0.7 * parameters.elastic_shear_number;
    parameters.plastic_shear_number = 0.003 * parameters.elastic_shear_number * N * N + 100.0;
    parameters.failure_ratio = std::min(0.99, 1.1 * std::pow(N, -0.15));
    parameters.constant_volume_friction_deg =
        constant_volume_friction_deg.value_or(parameters.constant_volume_friction_deg);
    parameters.peak_friction_deg =
        parameters.constant_volume_friction_deg + N / 10.0 + std::max(0.0, (N - 15.0) / 5.0);
    return parameters;
}

UbcSandParameters ubcsand_from_relative_density(double relative_density)
{
    require(relative_density > 0.0 && relative_density <= 1.0, "relative_density", relative_density,
            "above 0 and at most 1");
    return ubcsand_from_blow_count(blow_count(relative_density));
}

UbcSandParameters calibrated(UbcSandParameters generic)
{
    const double N = blow_count(generic.relative_density);
    UbcSandParameters parameters = generic;
    parameters.secondary_factor = 0.6 * std::pow(6.0 / N, 0.33);
    parameters.softened_factor = 0.02 * std::pow(6.0 / N, 0.8);
    parameters.confining_exponent = 0.18;
    parameters.lateral_exponent = 12.0 / N;
    parameters.static_shear_stiffening = 9.0 + N * N / 50.0;
    parameters.least_start_ratio = 1.0 / 3.0; // that of K_0 = 1/2
    parameters.dilation_factor = 5.0 * std::min(1.0, std::sqrt(6.0 / N));
    parameters.dilation_strain = 0.12 * std::pow(6.0 / N, 1.5);
    parameters.reference_strain = 4.5e-4;
    parameters.least_modulus_fraction = 0.35;
    parameters.reconsolidation_slope = 1.5 * std::exp(-0.369 * std::sqrt(N));
    parameters.liquefied_conductivity = 5.0;
    parameters.out_of_plane = OutOfPlaneStress::within_failure;
    return parameters;
}

UbcSandParameters with(const UbcSandRunSettings& settings, UbcSandParameters parameters)
{
    parameters.integration = settings.integration;
    parameters.ripple_strain = settings.ripple_strain;
    parameters.largest_ratio_step = settings.largest_ratio_step;
    parameters.largest_stress_step = settings.largest_stress_step;
    parameters.resolved_floors = settings.resolved_floors;
    parameters.substep_tolerance = settings.substep_tolerance;
    return parameters;
}

UbcSandParameters nevada_sand_55()
{
    return ubcsand_from_relative_density(nevada_relative_density);
}

void check(const UbcSandParameters& m)
{
    require_positive("elastic_shear_number", m.elastic_shear_number);
    require_positive("elastic_bulk_number", m.elastic_bulk_number);
    require_positive("plastic_shear_number", m.plastic_shear_number);
    for (const double exponent :
         {m.elastic_shear_exponent, m.elastic_bulk_exponent, m.plastic_shear_exponent}) {
        require(exponent >= 0.0 && exponent <= 1.0, "an exponent of the stress", exponent, "from 0 to 1");
    }
    require(m.failure_ratio >= 0.0 && m.failure_ratio < 1.0, "failure_ratio", m.failure_ratio,
            "from 0 to below 1");
    require(m.constant_volume_friction_deg > 0.0 && m.constant_volume_friction_deg < 60.0,
            "constant_volume_friction_deg", m.constant_volume_friction_deg, "above 0 and below 60");
    require(m.peak_friction_deg > 0.0 && m.peak_friction_deg < 60.0, "peak_friction_deg", m.peak_friction_deg,
            "above 0 and below 60");
    require_not_negative("cohesion", m.cohesion);
    require_positive("virgin_factor", m.virgin_factor);
    require_positive("secondary_factor", m.secondary_factor);
    require_positive("secondary_start", m.secondary_start);
    require_not_negative("secondary_growth", m.secondary_growth);
    require_not_negative("reversal_tolerance", m.reversal_tolerance);
    require_not_negative("ripple_strain", m.ripple_strain);
    require_not_negative("dilation_softening", m.dilation_softening);
    require_positive("softened_factor", m.softened_factor);
    require_not_negative("confining_exponent", m.confining_exponent);
    require_not_negative("lateral_exponent", m.lateral_exponent);
    require_not_negative("static_shear_stiffening", m.static_shear_stiffening);
    require(m.least_start_ratio >= 0.0 && m.least_start_ratio < 1.0, "least_start_ratio", m.least_start_ratio,
            "from 0 to below 1");
    require(m.dilation_factor >= 1.0 && std::isfinite(m.dilation_factor), "dilation_factor",
            m.dilation_factor, "at least 1");
    require(m.dilation_strain > 0.0, "dilation_strain", m.dilation_strain, "positive");
    require(m.reference_strain > 0.0, "reference_strain", m.reference_strain, "positive");
    require(m.least_modulus_fraction > 0.0 && m.least_modulus_fraction <= 1.0, "least_modulus_fraction",
            m.least_modulus_fraction, "above 0 and at most 1");
    require_not_negative("reconsolidation_slope", m.reconsolidation_slope);
    require(m.liquefied_conductivity >= 1.0 && std::isfinite(m.liquefied_conductivity),
            "liquefied_conductivity", m.liquefied_conductivity, "at least 1");
    require(m.static_poisson_ratio >= 0.0 && m.static_poisson_ratio < 0.5, "static_poisson_ratio",
            m.static_poisson_ratio, "from 0 to below 0.5");
    require_positive("largest_ratio_step", m.largest_ratio_step);
    require_positive("largest_stress_step", m.largest_stress_step);
    require_not_negative("resolved_floors", m.resolved_floors);
    require_positive("substep_tolerance", m.substep_tolerance);
    require_positive("stress_floor", m.stress_floor);
    require(m.largest_specific_volume > 0.0, "largest_specific_volume", m.largest_specific_volume,
            "positive");
    require(m.smallest_specific_volume >= 0.0 && m.smallest_specific_volume < m.largest_specific_volume,
            "smallest_specific_volume", m.smallest_specific_volume, "not negative, below the largest");
    require_stable_flow(m);
}

} // namespace quicksand
