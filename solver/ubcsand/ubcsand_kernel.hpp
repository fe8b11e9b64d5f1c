// One substep of UBCSAND, equation by equation: straight lines of arithmetic that a single point and a vector
// of points share, so that both give the same bits.
//
// Symbols    s = (sigma_x + sigma_y)/2, q = ((sigma_x - sigma_y)/2, tau_xy), t = |q|
//            a = c cot phi_f, sb = s + a, r = q/sb, eta = t/sb = sin of the mobilised friction angle
//            lambda = plastic shear strain, D = sin phi_cv - eta = plastic contraction per lambda, but not
//            negative in the loosest sand and not positive in the densest
//            K' = B + G/3, E1 = B + 4G/3, E2 = B - 2G/3
// Units/signs  Pa; stress and strain are compression positive in here, shear strain is engineering shear.
// Numbers    [1] to [10] are the steps of the algorithm as the docstring of `update` lists them.
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/ubcsand/ubcsand_memory.hpp"
#include "solver/ubcsand/ubcsand_power.hpp"

#include <cmath>

namespace quicksand::ubcsand {

struct Moduli {
    double G, B, E1, E2, K; // [Pa]
};

inline Moduli moduli_of(double G, double B)
{
    return {G, B, B + G * (4.0 / 3.0), B - G * (2.0 / 3.0), B + G * (1.0 / 3.0)};
}

inline constexpr bool has_square_roots(ElasticForm form)
{
    return form == ElasticForm::square_roots || form == ElasticForm::softening_square_roots;
}

inline constexpr bool softens(ElasticForm form)
{
    return form == ElasticForm::softening_powers || form == ElasticForm::softening_square_roots;
}

/// [3] Elastic moduli at a mean stress, G that of the smallest strains.
template <ElasticForm form>
Moduli elastic_moduli(const UbcSand& m, double s)
{
    const double ratio = s * (1.0 / atmospheric_pressure);
    if constexpr (has_square_roots(form)) {
        const double root = std::sqrt(ratio);
        return moduli_of(m.G_atm * root, m.B_atm * root);
    } else {
        return moduli_of(m.G_atm * power(ratio, m.ne), m.B_atm * power(ratio, m.me));
    }
}

/// The same for a law whose form is asked here.
inline Moduli moduli_at(const UbcSand& m, double s)
{
    return has_square_roots(m.elastic) ? elastic_moduli<ElasticForm::square_roots>(m, s)
                                       : elastic_moduli<ElasticForm::powers>(m, s);
}

/// The moduli after a relative change of the mean stress, (1 + fraction)^n = 1 + n fraction + ...
inline Moduli changed_moduli(const UbcSand& m, const Moduli& moduli, double fraction)
{
    return moduli_of(moduli.G * (1.0 + m.ne * fraction), moduli.B * (1.0 + m.me * fraction));
}

struct Strain {
    double x, y, xy; // [-]
};

/// Strain of the grain skeleton: zero where the grains have lost contact, which is at the stress floor in
/// sand looser than the loosest.
inline Strain borne(const UbcSand& m, const UbcSandState& state, const Strain& strain)
{
    constexpr double rounding = 1.0 + 1e-9;
    const double at_floor = select(0.5 * (state.sigma_x + state.sigma_y) <= m.s_min * rounding, 1.0, 0.0);
    const double fraction = 1.0 - at_floor * (1.0 + state.least_contraction);
    return {fraction * strain.x, fraction * strain.y, fraction * strain.xy};
}

/// Stress of a point as the substep finds it.
struct Start {
    Moduli moduli;        // there
    double s_old, s;      // as it is, and not below the floor [Pa]
    double sb;            // [Pa]
    double per_s, per_sb; // 1/s, 1/sb [1/Pa]
    double q_x, q_y;      // [Pa]
    double squared;       // t^2 [Pa^2]
};

template <ElasticForm form>
Start start_of(const UbcSand& m, const UbcSandState& state)
{
    Start start;
    start.s_old = 0.5 * (state.sigma_x + state.sigma_y);
    start.s = larger(start.s_old, m.s_min);
    start.sb = start.s + m.a;
    const Inverses per = inverses(start.s, start.sb);
    start.per_s = per.of_a;
    start.per_sb = per.of_b;
    start.q_x = 0.5 * (state.sigma_x - state.sigma_y);
    start.q_y = state.tau_xy;
    start.squared = start.q_x * start.q_x + start.q_y * start.q_y;
    start.moduli = elastic_moduli<form>(m, start.s);
    return start;
}

/// Half of the change of the mean stress, over it: where the middle of a substep is. With exponents of 1/2
/// the moduli there give the exact stress of an elastic substep. [-]
inline double half_change(const Start& start, double s_end)
{
    return smaller(4.0, larger(-0.5, 0.5 * (s_end - start.s) * start.per_s));
}

/// Most substeps of one update: an absurd strain is then taken in larger ones, stable but coarse. [-]
inline constexpr double most_substeps = 100000.0;

/// The least whole number that is not smaller, but 1.
inline double count_of(double demand)
{
    constexpr double shift = 0x1.8p52; // adding 1.5 x 2^52 rounds to the nearest
    const double nearest = (demand + shift) - shift;
    return larger(1.0, nearest + select(nearest < demand, 1.0, 0.0));
}

/// [2] Fraction of the strain that the next substep of first order takes. It moves the stress ratio by at
/// most the given step, were it elastic, and the mean stress, relatively, by at most its step; below the
/// resolved stress by as much as there: in liquefied sand the ratio changes at the least strain, but the
/// stresses hardly.
inline double fixed_fraction(const UbcSand& m, const Start& start, const Strain& strain, double budget)
{
    const double G = start.moduli.G;
    const double dq_x = G * (strain.x - strain.y), dq_y = G * strain.xy;
    const double resolved = larger(start.s, m.resolved);
    const Inverses per = inverses(resolved, resolved + m.a);
    const double by_stress = std::abs(start.moduli.K * (strain.x + strain.y)) * m.per_stress_step * per.of_a;
    const double by_ratio = std::sqrt(dq_x * dq_x + dq_y * dq_y) * m.per_ratio_step * per.of_b;
    return 1.0 / count_of(smaller(larger(by_ratio, by_stress), budget));
}

inline Strain part_of(const Strain& strain, double fraction)
{
    return {strain.x * fraction, strain.y * fraction, strain.xy * fraction};
}

/// What remains after a part.
inline Strain rest_of(const Strain& strain, const Strain& part)
{
    return {strain.x - part.x, strain.y - part.y, strain.xy - part.xy};
}

/// What an elastic substep would give, and whether the locus stands in its way.
struct Trial {
    Start start;
    double s;           // not below the floor [Pa]
    double q_x, q_y, t; // [Pa]
    double sigma_z;     // before the substep [Pa]
    double volumetric;  // strain of the substep [-]
    double shear_x;     // eps_x - eps_y of the substep [-]
    double shear_y;     // its gamma_xy [-]
    double E2;          // in the middle of the substep [Pa]
    double eta_y;       // ratio of the locus [-]
    double least_D;     // of the state [-]
    double most_D;      // [-]
    double branch;      // before the substep, with the departure from where it turned noticed
    bool plastic;
};

/// [5] Ratio of the yield locus: the present one in loading and on a branch that has left its reversal, the
/// one at the reversal for a tiny excursion.
inline void place_locus(const UbcSand& m, const UbcSandState& state, Trial& trial)
{
    const double per_sb = trial.start.per_sb;
    const double away_x = trial.start.q_x * per_sb - state.peak_x;
    const double away_y = trial.start.q_y * per_sb - state.peak_y;
    const double departed =
        select(away_x * away_x + away_y * away_y >= m.tolerance_squared, far_from_reversal, strain_reversed);
    trial.branch = select(state.branch == strain_reversed, departed, state.branch);
    const double eta_squared = trial.start.squared * per_sb * per_sb;
    const double peak_squared = state.peak_x * state.peak_x + state.peak_y * state.peak_y;
    const double held =
        select(trial.branch < far_from_reversal, larger(eta_squared, peak_squared), eta_squared);
    trial.eta_y = smaller(std::sqrt(held), m.eta_f);
}

/// G over that of the smallest strains, mean over a shear strain: with the strain since it turned G falls by
/// (1 + gamma/(2 gamma_r))^-2, so that the shear stress goes by gamma/(1 + gamma/(2 gamma_r)). On the way
/// back from the farthest point the strain counts from there.
inline double small_strain_fraction(const UbcSand& m, const UbcSandState& state, double shear_x,
                                    double shear_y)
{
    const double back = state.back_x * state.back_x + state.back_y * state.back_y;
    const double along = state.leg_x * shear_x + state.leg_y * shear_y;
    const double goes_on = select(along < 0.0, 0.0, 1.0);
    const double x = select(back > 0.0, state.back_x, goes_on * state.leg_x);
    const double y = select(back > 0.0, state.back_y, goes_on * state.leg_y);
    const double end_x = x + shear_x, end_y = y + shear_y;
    const double start = 1.0 + m.per_small_strain * std::sqrt(x * x + y * y);
    const double end = 1.0 + m.per_small_strain * std::sqrt(end_x * end_x + end_y * end_y);
    return larger(m.least_fraction, 1.0 / (start * end));
}

/// [3] to [7] up to the decision. In second order with the moduli of the middle of the substep.
template <Integration order, ElasticForm form>
Trial elastic_trial(const UbcSand& m, const UbcSandState& state, const Start& start, const Strain& strain)
{
    Trial trial;
    trial.start = start;
    trial.sigma_z = state.sigma_z;
    trial.least_D = state.least_contraction;
    trial.most_D = state.most_contraction;
    trial.volumetric = strain.x + strain.y;
    trial.shear_x = strain.x - strain.y;
    trial.shear_y = strain.xy;

    // [4] d s = K' d eps_v, d q = G (d eps_x - d eps_y, d gamma_xy); s as it is, be it below the floor
    if constexpr (softens(form)) {
        const double fraction = small_strain_fraction(m, state, trial.shear_x, trial.shear_y);
        trial.start.moduli = moduli_of(fraction * start.moduli.G, start.moduli.B);
    }
    Moduli moduli = trial.start.moduli;
    if constexpr (order == Integration::second_order) {
        const double change = half_change(start, start.s + moduli.K * trial.volumetric);
        moduli = changed_moduli(m, trial.start.moduli, change);
    }
    trial.q_x = start.q_x + moduli.G * trial.shear_x;
    trial.q_y = start.q_y + moduli.G * trial.shear_y;
    trial.t = std::sqrt(trial.q_x * trial.q_x + trial.q_y * trial.q_y);
    trial.E2 = moduli.E2;
    trial.s = larger(start.s_old + moduli.K * trial.volumetric, m.s_min); // [6]
    place_locus(m, state, trial);                                         // [5]
    trial.plastic = trial.t > trial.eta_y * (trial.s + m.a);              // [7]
    return trial;
}

/// [10] Stress from its parts in the plane, t = |q|.
inline void set_stress(const UbcSand& m, double s, double q_x, double q_y, double t, double sigma_z,
                       UbcSandState& state)
{
    const double sb = s + m.a, most = (sb - t) * m.most_z - m.a, least = (sb + t) * m.least_z - m.a;
    state.sigma_x = s + q_x;
    state.sigma_y = s - q_x;
    state.sigma_z = larger(larger(smaller(sigma_z, most), least), 0.2 * m.s_min);
    state.tau_xy = q_y;
}

/// [7] The elastic end: the first elastic substep after loading is a reversal, which is remembered.
inline void finish_elastic(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    const bool reversal = trial.branch == loading;
    state.peak_x = select(reversal, trial.start.q_x * trial.start.per_sb, state.peak_x);
    state.peak_y = select(reversal, trial.start.q_y * trial.start.per_sb, state.peak_y);
    const double turned = follow_strain(m, trial.shear_x, trial.shear_y, state);
    const double resumed = select(trial.branch == loading_in_ripple, far_from_reversal, trial.branch);
    const double branch = select(reversal, just_reversed, resumed);
    state.branch = select(turned > 0.0, larger(branch, strain_reversed), branch);
    count_half_cycles(m, turned, 0.0, state);
    set_stress(m, trial.s, trial.q_x, trial.q_y, trial.t, trial.sigma_z + trial.E2 * trial.volumetric, state);
}

} // namespace quicksand::ubcsand
