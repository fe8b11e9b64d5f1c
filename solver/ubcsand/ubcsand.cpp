#include "solver/ubcsand/ubcsand.hpp"

#include "solver/ubcsand/ubcsand_attempt.hpp"

#include <numbers>

namespace quicksand {

namespace {

double mean_stress(const UbcSand& law, const UbcSandState& state)
{
    return ubcsand::larger(0.5 * (state.sigma_x + state.sigma_y), law.s_min);
}

ubcsand::Moduli present_moduli(const UbcSand& law, const UbcSandState& state)
{
    return ubcsand::moduli_at(law, mean_stress(law, state));
}

/// In substeps of first order.
template <ElasticForm form>
void advance_in_first_order(const UbcSand& law, ubcsand::Strain remaining, UbcSandState& state)
{
    constexpr Integration order = Integration::first_order;
    const auto flow = ubcsand::locking_of(law) == ubcsand::Locking::none
                          ? ubcsand::finish_in_first_order<ubcsand::Locking::none>
                          : ubcsand::finish_in_first_order<ubcsand::Locking::by_dilation>;
    double fraction = 0.0;
    for (double budget = ubcsand::most_substeps; budget > 0.0 && fraction < 1.0; budget -= 1.0) {
        const ubcsand::Start start = ubcsand::start_of<form>(law, state);
        fraction = ubcsand::fixed_fraction(law, start, remaining, budget);
        const ubcsand::Strain strain = ubcsand::part_of(remaining, fraction);
        const ubcsand::Trial trial = ubcsand::elastic_trial<order, form>(law, state, start, strain);
        if (trial.plastic) {
            flow(law, trial, state);
        } else {
            ubcsand::finish_elastic(law, trial, state);
        }
        remaining = ubcsand::rest_of(remaining, strain);
    }
}

template <ubcsand::Locking locking>
ubcsand::Verdict flow_in_second_order(const UbcSand& law, const ubcsand::Trial& trial, double event,
                                      UbcSandState& next)
{
    double error = 0.0;
    ubcsand::finish_in_second_order<locking>(law, trial, next, error);
    return ubcsand::judge_plastic<locking>(law, trial, error, event, next);
}

/// Try a substep of second order; the state changes if it stands.
template <ElasticForm form>
ubcsand::Verdict try_substep(const UbcSand& law, const ubcsand::Start& start, const ubcsand::Strain& strain,
                             bool ends_at_event, bool last_try, UbcSandState& state)
{
    const ubcsand::Trial trial =
        ubcsand::elastic_trial<Integration::second_order, form>(law, state, start, strain);
    UbcSandState next = state;
    ubcsand::finish_elastic(law, trial, next);
    ubcsand::Events events = {0.0, 0.0};
    if (!ends_at_event) events = ubcsand::events_of(law, trial, state);
    ubcsand::Verdict verdict = ubcsand::judge_elastic(law, trial, events.elastic);
    if (trial.plastic) {
        next = state;
        verdict = ubcsand::locking_of(law) == ubcsand::Locking::none
                      ? flow_in_second_order<ubcsand::Locking::none>(law, trial, events.plastic, next)
                      : flow_in_second_order<ubcsand::Locking::by_dilation>(law, trial, events.plastic, next);
    }
    if (last_try) verdict.excess = 0.0;
    if (verdict.stands()) state = next;
    return verdict;
}

/// In substeps of second order: the whole strain first, and what does not stand from event to event.
template <ElasticForm form>
void advance_in_second_order(const UbcSand& law, ubcsand::Strain remaining, UbcSandState& state)
{
    const ubcsand::Start at_once = ubcsand::start_of<form>(law, state);
    ubcsand::Verdict verdict = try_substep<form>(law, at_once, remaining, false, false, state);
    if (verdict.stands()) return;
    double size = ubcsand::smaller(1.0, verdict.longer), fraction = 0.0;
    for (double budget = ubcsand::most_substeps; budget > 0.0; budget -= 1.0) {
        const ubcsand::Start start = ubcsand::start_of<form>(law, state);
        fraction = ubcsand::next_fraction(law, start, state, remaining, size, budget);
        const ubcsand::Strain strain = ubcsand::part_of(remaining, fraction);
        verdict = try_substep<form>(law, start, strain, true, budget <= 1.0, state);
        size = ubcsand::next_size(verdict, fraction);
        if (!verdict.stands()) continue;
        if (fraction >= 1.0) return;
        remaining = ubcsand::rest_of(remaining, strain);
    }
}

template <ElasticForm form>
void advance(const UbcSand& law, const ubcsand::Strain& strain, UbcSandState& state)
{
    if (law.integration == Integration::first_order) {
        advance_in_first_order<form>(law, strain, state);
    } else {
        advance_in_second_order<form>(law, strain, state);
    }
}

ElasticForm elastic_form(const UbcSandParameters& m)
{
    const bool roots = m.elastic_shear_exponent == 0.5 && m.elastic_bulk_exponent == 0.5;
    if (std::isfinite(m.reference_strain) && m.least_modulus_fraction < 1.0)
        return roots ? ElasticForm::softening_square_roots : ElasticForm::softening_powers;
    return roots ? ElasticForm::square_roots : ElasticForm::powers;
}

/// sigma_z + a at most N_phi times the least of the plane, and at least the largest over N_phi.
void bound_out_of_plane(OutOfPlaneStress bound, UbcSand& law)
{
    constexpr double without_bound = 1e290;
    const double N = (1.0 + law.eta_f) / (1.0 - law.eta_f);
    const bool bounded = bound == OutOfPlaneStress::within_failure;
    law.most_z = bounded ? N : without_bound;
    law.least_z = bounded ? 1.0 / N : 0.0;
}

/// What the stress at the start of shaking makes of the plastic modulus.
double start_factor_of(const UbcSand& law, const UbcSandState& start)
{
    const double vertical = ubcsand::larger(start.sigma_y, law.s_min);
    const double k0 = ubcsand::larger(start.sigma_x, law.s_min) / vertical;
    constexpr double usual_k0 = 0.5; // of the triggering curve
    return std::pow(ubcsand::larger(1.0, vertical / atmospheric_pressure), -law.m_v) *
           std::pow((1.0 + k0) / (1.0 + usual_k0), law.m_h) *
           (1.0 + law.static_shear * std::abs(start.tau_xy) / vertical);
}

} // namespace

UbcSand make_ubcsand(const UbcSandParameters& parameters)
{
    check(parameters);
    const UbcSandParameters& m = parameters;
    const double degree = std::numbers::pi / 180.0;
    UbcSand law;
    law.G_atm = m.elastic_shear_number * atmospheric_pressure;
    law.B_atm = m.elastic_bulk_number * atmospheric_pressure;
    law.Gp_atm = m.plastic_shear_number * atmospheric_pressure;
    law.ne = m.elastic_shear_exponent;
    law.me = m.elastic_bulk_exponent;
    law.np = m.plastic_shear_exponent;
    law.sin_cv = std::sin(m.constant_volume_friction_deg * degree);
    law.eta_f = std::sin(m.peak_friction_deg * degree);
    law.R = m.failure_ratio / law.eta_f;
    law.a = m.cohesion / std::tan(m.peak_friction_deg * degree);
    law.h1 = m.virgin_factor;
    law.h2 = m.secondary_factor;
    law.s0 = m.secondary_start;
    law.s1 = m.secondary_growth;
    law.tolerance_squared = m.reversal_tolerance * m.reversal_tolerance;
    law.ripple_squared = m.ripple_strain * m.ripple_strain;
    law.a_dil_log2 = m.dilation_softening * std::numbers::log2e;
    law.fac_post = m.softened_factor;
    law.m_v = m.confining_exponent;
    law.m_h = m.lateral_exponent;
    law.static_shear = m.static_shear_stiffening;
    law.least_start_ratio = m.least_start_ratio;
    law.dilation = m.dilation_factor;
    law.per_dilation = 1.0 / m.dilation_strain;
    law.per_small_strain = 0.5 / m.reference_strain;
    law.least_fraction = m.least_modulus_fraction;
    law.reconsolidation = m.reconsolidation_slope;
    law.liquefied_conductivity = m.liquefied_conductivity;
    bound_out_of_plane(m.out_of_plane, law);
    law.s_min = m.stress_floor;
    law.static_poisson = m.static_poisson_ratio;
    law.per_ratio_step = 1.0 / m.largest_ratio_step;
    law.per_stress_step = 1.0 / m.largest_stress_step;
    law.largest_specific_volume = m.largest_specific_volume;
    law.smallest_specific_volume = m.smallest_specific_volume;
    law.resolved = m.resolved_floors * m.stress_floor;
    law.substep_tolerance = m.substep_tolerance;
    law.integration = m.integration;
    law.elastic = elastic_form(parameters);
    law.remembers = SandMemory::of_cycles;
    return law;
}

void begin_shaking(const UbcSand& law, UbcSandState& state)
{
    const double sb = mean_stress(law, state) + law.a;
    UbcSandState fresh;
    fresh.sigma_x = state.sigma_x;
    fresh.sigma_y = state.sigma_y;
    fresh.sigma_z = state.sigma_z;
    fresh.tau_xy = state.tau_xy;
    fresh.peak_x = 0.5 * (state.sigma_x - state.sigma_y) / sb;
    fresh.peak_y = state.tau_xy / sb;
    fresh.eta_max = ubcsand::larger(std::sqrt(fresh.peak_x * fresh.peak_x + fresh.peak_y * fresh.peak_y),
                                    law.least_start_ratio);
    fresh.start_factor = start_factor_of(law, state);
    fresh.static_y = state.tau_xy / ubcsand::larger(state.sigma_y, law.s_min);
    fresh.origin_x = fresh.peak_x;
    fresh.origin_y = fresh.peak_y;
    fresh.branch = ubcsand::loading;
    state = fresh;
}

void turn(double spin, UbcSandState& state)
{
    const Rotation rotation = rotation_of(spin);
    ubcsand::turn_stress(rotation, state);
    ubcsand::turn_memory(rotation, state);
}

void update(const UbcSand& law, const UbcSandIncrement& increment, UbcSandState& state)
{
    turn(increment.spin, state);
    const ubcsand::Strain strain =
        ubcsand::borne(law, state, {increment.strain_x, increment.strain_y, increment.shear});
    switch (law.elastic) {
    case ElasticForm::powers:
        return advance<ElasticForm::powers>(law, strain, state);
    case ElasticForm::square_roots:
        return advance<ElasticForm::square_roots>(law, strain, state);
    case ElasticForm::softening_powers:
        return advance<ElasticForm::softening_powers>(law, strain, state);
    case ElasticForm::softening_square_roots:
        return advance<ElasticForm::softening_square_roots>(law, strain, state);
    }
}

double shear_modulus(const UbcSand& law, const UbcSandState& state)
{
    return present_moduli(law, state).G;
}

double constrained_modulus(const UbcSand& law, const UbcSandState& state)
{
    return present_moduli(law, state).E1;
}

} // namespace quicksand
