// The plastic part of a substep of UBCSAND: how stiffly the locus hardens, how far the sand flows, and what
// it remembers of it.
//
// Symbols    as in ubcsand_kernel.hpp; G^p = plastic shear modulus, u = 1 - R_f eta/eta_f
// Order      First order is the published algorithm, to whose numbers the law is held: every coefficient is
//            that of the substep's start, and the sense of loading that of its trial. Second order takes them
//            where they belong: ubcsand_turning.hpp.
#pragma once

#include "solver/ubcsand/ubcsand_kernel.hpp"

namespace quicksand::ubcsand {

/// A stress on the path of the trial, q [Pa].
struct Deviator {
    double x, y;
};

/// How far along the trial's path loading shows its sense, in second order: hardly, but rounding.
inline constexpr double early = 0.01; // [-]

/// Where loading shows its sense.
template <Integration order>
Deviator at_beginning(const Trial& trial)
{
    if constexpr (order == Integration::first_order) {
        return {trial.q_x, trial.q_y};
    } else {
        return {(1.0 - early) * trial.start.q_x + early * trial.q_x,
                (1.0 - early) * trial.start.q_y + early * trial.q_y};
    }
}

/// Where the branch of a substep shows its sense.
template <Integration order>
Deviator at_middle(const Trial& trial)
{
    if constexpr (order == Integration::first_order) {
        return {trial.q_x, trial.q_y};
    } else {
        return {trial.start.q_x + trial.q_x, trial.start.q_y + trial.q_y};
    }
}

/// Not positive when the stress is on the other side of the isotropic axis than r.
inline double accord(const Deviator& q, double r_x, double r_y)
{
    return q.x * r_x + q.y * r_y;
}

/// Whether sand locks in the sense of its last dilation, as sand with a dilation_strain does: kernels of
/// other sand do not ask.
enum class Locking { none, by_dilation };

inline Locking locking_of(const UbcSand& m)
{
    return m.per_dilation > 0.0 ? Locking::by_dilation : Locking::none;
}

/// Whether the sand has dilated last in the sense of q: its grains stand against more of it.
inline bool is_locked(const Deviator& q, const UbcSandState& state)
{
    return accord(q, state.dilated_x, state.dilated_y) > 0.0;
}

/// Not positive where dilation softens a branch: it has crossed the isotropic axis since the last turn of the
/// stress or of the strain. Locked sand softens in the other sense, and in that of a static shear.
template <Locking locking>
inline double softening_accord(const Deviator& q, const UbcSandState& state)
{
    const double least =
        smaller(accord(q, state.origin_x, state.origin_y), accord(q, state.peak_x, state.peak_y));
    if constexpr (locking == Locking::none) return least;
    const double locked = larger(least, accord(q, state.dilated_x, state.dilated_y));
    const double dilated = state.dilated_x * state.dilated_x + state.dilated_y * state.dilated_y;
    const double kept = select(accord(q, state.static_x, state.static_y) > 0.0, least, locked);
    return select(dilated > 0.0, kept, least);
}

/// What G^p falls to after a dilation, on a branch that it softens: a factor. [8b]
template <Locking locking>
inline double softening(const UbcSand& m, const Deviator& q, const UbcSandState& state)
{
    const double loss = larger(-1000.0, -m.a_dil_log2 * state.active_dilation); // exp as a power of 2
    const double factor = select(state.active_dilation > 0.0, exponential_2(loss), 1.0);
    return select(softening_accord<locking>(q, state) <= 0.0, factor, 1.0);
}

/// F of secondary loading, up to the largest ratio so far, and of virgin loading beyond it. [8a, 8b]
struct HardeningFactors {
    double secondary, virgin; // [-]
};

inline HardeningFactors softened_factors(const UbcSand& m, double factor, const UbcSandState& state)
{
    const double least =
        select(factor < 1.0, m.fac_post / (1.0 + state.active_dilation * m.per_dilation), 0.0);
    return {larger(least, factor * (m.h1 * m.h2 * (m.s0 + m.s1 * state.half_cycles)) * state.start_factor),
            larger(least, factor * m.h1 * state.start_factor)};
}

/// The static shear over the vertical stress under which locked sand flows as if it were not.
inline constexpr double whole_static_shear = 0.2; // [-]

/// The static shear in the sense of q over the whole one [-].
inline double part_of_static_shear(const Deviator& q, const UbcSandState& state)
{
    constexpr double least = 1e-200; // [Pa]
    const double size = larger(std::sqrt(q.x * q.x + q.y * q.y), least);
    const double along = larger(0.0, accord(q, state.static_x, state.static_y)) / size;
    return smaller(1.0, along * (1.0 / whole_static_shear));
}

/// Sand that is locked in the sense of its static shear makes a part of its flow there softened all the same,
/// in proportion to that shear, and the rest as hard sand: 1/F = part/F_soft + (1 - part)/F_hard.
template <Locking locking>
inline HardeningFactors hardening_factors(const UbcSand& m, const Deviator& q, const UbcSandState& state)
{
    const double factor = softening<locking>(m, q, state);
    if constexpr (locking == Locking::none) {
        return softened_factors(m, factor, state); // a named one would stay in memory, and no vectors be made
    } else {
        const HardeningFactors soft = softened_factors(m, factor, state),
                               hard = softened_factors(m, 1.0, state);
        const double part = part_of_static_shear(q, state), rest = 1.0 - part;
        const Inverses per =
            inverses(part * hard.secondary + rest * soft.secondary, part * hard.virgin + rest * soft.virgin);
        const double partial = select(is_locked(q, state), factor, 1.0);
        return {select(partial < 1.0, soft.secondary * hard.secondary * per.of_a, soft.secondary),
                select(partial < 1.0, soft.virgin * hard.virgin * per.of_b, soft.virgin)};
    }
}

/// K_G^p P_a (s/P_a)^np [Pa]
inline double plastic_number(const UbcSand& m, double s)
{
    return m.Gp_atm * power(s * (1.0 / atmospheric_pressure), m.np);
}

/// G^p of a factor of 1: the hyperbola, K_G^p P_a (s/P_a)^np (1 - R_f eta/eta_f)^2. [Pa]
inline double plastic_modulus(const UbcSand& m, double number, double eta)
{
    const double u = 1.0 - m.R * eta;
    return number * (u * u);
}

struct PlasticFlow {
    double s, t;        // after the return [Pa]
    double lambda;      // plastic shear strain [-]
    double contraction; // plastic volumetric strain [-]
    double dilating;    // part of lambda above the ratio of constant volume [-]
};

inline PlasticFlow select(bool condition, const PlasticFlow& yes, const PlasticFlow& no)
{
    return {select(condition, yes.s, no.s), select(condition, yes.t, no.t),
            select(condition, yes.lambda, no.lambda), select(condition, yes.contraction, no.contraction),
            select(condition, yes.dilating, no.dilating)};
}

/// A place on the substep where the coefficients are taken, and the trial that goes with them.
struct Place {
    Moduli moduli;
    double number;  // K_G^p P_a (s/P_a)^np [Pa]
    double eta;     // [-]
    double sb;      // [Pa]
    double growth;  // sb after the substep over sb here [-]
    double t_trial; // [Pa]
    double s_trial; // [Pa]
};

/// D at a ratio [-].
inline double contraction(const UbcSand& m, const Trial& trial, double eta)
{
    const double D = m.sin_cv - eta;
    return smaller(trial.most_D, larger(trial.least_D, select(D < 0.0, m.dilation * D, D)));
}

/// [8, 8c] Return to the locus or to the failure line with the coefficients of the start, in first order:
/// lambda = (t - eta_y sb)/(G + G^p - eta_y K' D), ds = -K' D lambda, dt = -G lambda.
inline PlasticFlow flow_from_start(const UbcSand& m, const Trial& trial, double G_p)
{
    const double G = trial.start.moduli.G, K = trial.start.moduli.K, sb = trial.s + m.a;
    const double D = contraction(m, trial, trial.eta_y);
    const double D_f = contraction(m, trial, m.eta_f);
    const double lambda = (trial.t - trial.eta_y * sb) / (G + G_p - trial.eta_y * K * D);
    const double failing = larger(0.0, (trial.t - m.eta_f * sb) / (G - m.eta_f * K * D_f));
    const bool fails = trial.t - G * lambda > m.eta_f * (trial.s - K * D * lambda + m.a);
    const double flowed = select(fails, failing, lambda), contracted = select(fails, D_f, D) * flowed;
    return {trial.s - K * contracted, trial.t - G * flowed, flowed, contracted,
            select(contracted < 0.0, flowed, 0.0)};
}

/// The flow that hardens the locus, until that is the failure line: of a drive [Pa], the ways of the shear
/// stress to the largest ratio and on to failure [Pa], and on each of them the plastic modulus [Pa] and what
/// the flow takes off the drive [Pa]. Fractions are compared and chosen before the only division.
inline double hardening_flow(double drive, double to_largest, double to_failure, double secondary,
                             double virgin, double before, double beyond)
{
    const double rest = drive * secondary - to_largest * before; // of the drive, times the secondary modulus
    const bool is_secondary = rest <= 0.0;
    const double flow = select(is_secondary, drive, to_largest * beyond + rest);
    const double per_flow = select(is_secondary, before, secondary * beyond);
    const double most = to_largest * virgin + to_failure * secondary, per_most = secondary * virgin;
    const bool hardens = flow * per_most <= most * per_flow;
    return select(hardens, flow, most) / select(hardens, per_flow, per_most);
}

/// [8, 8c] Return to the hardened locus, t - eta_y sb = G^p lambda (sb after/sb here), ds = -K' D lambda,
/// dt = -G lambda. The locus hardens by the secondary factor up to the largest ratio and by the virgin one
/// from there, until it is the failure line; on that the rest of the flow is perfectly plastic.
inline PlasticFlow flow_on_locus(const UbcSand& m, const Trial& trial, const HardeningFactors& F,
                                 double eta_max, const Place& at)
{
    const double G = at.moduli.G, K = at.moduli.K, eta_y = trial.eta_y;
    const double D = contraction(m, trial, at.eta);
    const double D_f = contraction(m, trial, m.eta_f);
    const double modulus = plastic_modulus(m, at.number, at.eta);
    const double elastic = G - eta_y * K * D;
    const double secondary = F.secondary * modulus, virgin = F.virgin * modulus;
    const double sb_trial = at.s_trial + m.a;
    const double drive = larger(0.0, at.t_trial - eta_y * sb_trial);

    const double to_largest = larger(0.0, smaller(eta_max, m.eta_f) - eta_y) * at.sb;
    const double to_failure = (m.eta_f - smaller(m.eta_f, larger(eta_max, eta_y))) * at.sb;
    const double before = elastic + secondary * at.growth, beyond = elastic + virgin * at.growth;
    const double first = hardening_flow(drive, to_largest, to_failure, secondary, virgin, before, beyond);
    const double s_first = at.s_trial - K * D * first, t_first = at.t_trial - G * first;

    const double excess = larger(0.0, t_first - m.eta_f * (s_first + m.a)), softens = G - m.eta_f * K * D_f;
    const double sb_first = larger(s_first + m.a, m.s_min), reached = smaller(m.eta_f * sb_first, t_first);
    const double range = larger(reached - eta_y * sb_first, 1e-12 * sb_first);
    const double above = larger(0.0, reached - larger(m.sin_cv, eta_y) * sb_first);
    const Inverses per = inverses(softens, range);
    const double failing = excess * per.of_a;
    const double dilating = first * smaller(1.0, above * per.of_b); // where eta > sin phi_cv
    return {at.s_trial - K * D * first - K * D_f * failing, t_first - G * failing, first + failing,
            D * first + D_f * failing, failing + dilating};
}

/// [8d] Shear at the stress floor: constant s, so that dilation can later lift the point off it.
inline PlasticFlow flow_at_floor(const UbcSand& m, const Trial& trial, double G_p)
{
    const double G = trial.start.moduli.G, sb = m.s_min + m.a;
    const double lambda = larger(0.0, (trial.t - trial.eta_y * sb) / (G + G_p));
    return {m.s_min, smaller(trial.t - G * lambda, m.eta_f * sb), lambda, 0.0, 0.0};
}

/// [8] Loading begins, or goes on: count it, and soften a branch that has changed its sense. Unloading that
/// the strain interrupts by less than a turn reloads in a ripple, which is no loading yet.
template <Integration order>
void remember_loading(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    const double turned = follow_strain(m, trial.shear_x, trial.shear_y, state);
    const double back = state.back_x * state.back_x + state.back_y * state.back_y;
    const double resumed = select(trial.branch == loading_in_ripple, 1.0, 0.0);
    const double unloaded = select(trial.branch == far_from_reversal, 1.0, resumed);
    const double in_ripple = select(back > 0.0, select(turned > 0.0, 0.0, unloaded), 0.0);
    const double other_side =
        select(accord(at_beginning<order>(trial), state.peak_x, state.peak_y) <= 0.0, 1.0, 0.0);
    const double crossed = select(trial.branch < far_from_reversal, other_side, 0.0);
    const double loads = select(in_ripple > 0.0, 0.0, larger(unloaded, crossed));
    count_half_cycles(m, turned, loads, state);
    soften_by_dilation(m, loads * other_side, state);
    state.branch = select(in_ripple > 0.0, loading_in_ripple, loading);
}

/// [8] to [10] The plastic end of a substep by a flow, with q in a direction of any length.
inline void finish_flow(const UbcSand& m, const Trial& trial, const Deviator& direction, double E2,
                        PlasticFlow& flow, UbcSandState& state)
{
    flow.t =
        larger(0.0, smaller(flow.t, m.eta_f * (flow.s + m.a))); // rounding, and substeps beyond the budget
    state.dilation += flow.dilating;                            // [9]
    const double sb = flow.s + m.a;
    const double length = larger(std::sqrt(direction.x * direction.x + direction.y * direction.y), 1e-300);
    const Inverses per = inverses(sb, length);
    state.eta_max = larger(state.eta_max, flow.t * per.of_a);
    const double sigma_z = trial.sigma_z + E2 * (trial.volumetric - flow.contraction);
    const double ratio = flow.t * per.of_b;
    set_stress(m, flow.s, direction.x * ratio, direction.y * ratio, flow.t, sigma_z, state);
}

/// G^p at the ratio of the locus [Pa].
inline double modulus_of_locus(const UbcSand& m, const Trial& trial, const HardeningFactors& F, double number,
                               const UbcSandState& state)
{
    const double factor = select(trial.eta_y < state.eta_max - 1e-9, F.secondary, F.virgin);
    return factor * plastic_modulus(m, number, trial.eta_y);
}

/// The plastic end of a substep of first order; returns its flow.
template <Locking locking>
inline PlasticFlow finish_in_first_order(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    constexpr Integration order = Integration::first_order;
    remember_loading<order>(m, trial, state);
    const HardeningFactors F = hardening_factors<locking>(m, at_middle<order>(trial), state);
    const double number = plastic_number(m, trial.start.s);
    const double G_p = modulus_of_locus(m, trial, F, number, state);
    const PlasticFlow end = flow_from_start(m, trial, G_p);
    PlasticFlow flow = select(end.s < m.s_min, flow_at_floor(m, trial, G_p), end);
    finish_flow(m, trial, {trial.q_x, trial.q_y}, trial.start.moduli.E2, flow, state);
    return flow;
}

} // namespace quicksand::ubcsand
