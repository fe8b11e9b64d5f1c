// The plastic part of a substep of UBCSAND: how stiffly the locus hardens, and where the stress ends on it.
//
// Symbols    as in ubcsand_kernel.hpp; G^p = plastic shear modulus, u = 1 - R_f eta/eta_f
// Order      First order is the published algorithm, to whose numbers the law is held: every coefficient is
//            that of the substep's start. Second order takes them in its middle, from a first estimate of its
//            end, and turns where the locus meets the largest ratio, constant volume and failure; it is of
//            first order at the stress floor and for a tiny excursion.
#pragma once

#include "solver/ubcsand/ubcsand_kernel.hpp"

namespace quicksand::ubcsand {

/// Not positive when the trial's stress is on the other side of the isotropic axis than r.
inline double accord(const Trial& trial, double r_x, double r_y)
{
    return trial.q_x * r_x + trial.q_y * r_y;
}

/// What G^p falls to after a dilation, once the branch has crossed the isotropic axis: a factor. [8b]
inline double softening(const UbcSand& m, const Trial& trial, const UbcSandState& state)
{
    const double least_accord =
        smaller(accord(trial, state.origin_x, state.origin_y), accord(trial, state.peak_x, state.peak_y));
    const double loss = larger(-1000.0, -m.a_dil_log2 * state.active_dilation); // exp as a power of 2
    const double factor = select(state.active_dilation > 0.0, exponential_2(loss), 1.0);
    return select(least_accord <= 0.0, factor, 1.0);
}

/// F of secondary loading, up to the largest ratio so far, and of virgin loading beyond it. [8a, 8b]
struct HardeningFactors {
    double secondary, virgin; // [-]
};

inline HardeningFactors hardening_factors(const UbcSand& m, const Trial& trial, const UbcSandState& state)
{
    const double factor = softening(m, trial, state);
    const double least = select(factor < 1.0, m.fac_post, 0.0);
    return {larger(least, factor * (m.h1 * m.h2 * (m.s0 + m.s1 * state.half_cycles))),
            larger(least, factor * m.h1)};
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
    return smaller(trial.most_D, larger(trial.least_D, m.sin_cv - eta));
}

/// [8, 8c] Return to the locus or to the failure line with the coefficients of the start, in first order:
/// lambda = (t - eta_y sb)/(G + G^p - eta_y K' D), ds = -K' D lambda, dt = -G lambda.
inline PlasticFlow flow_from_start(const UbcSand& m, const Trial& trial, double G_p)
{
    const double G = trial.start.moduli.G, K = trial.start.moduli.K, sb = trial.s + m.a;
    const double D = contraction(m, trial, trial.eta_y), D_f = contraction(m, trial, m.eta_f);
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
    const double D = contraction(m, trial, at.eta), D_f = contraction(m, trial, m.eta_f);
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
inline void remember_loading(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    const double turned = follow_strain(m, trial.shear_x, trial.shear_y, state);
    const double back = state.back_x * state.back_x + state.back_y * state.back_y;
    const double resumed = select(trial.branch == loading_in_ripple, 1.0, 0.0);
    const double unloaded = select(trial.branch == far_from_reversal, 1.0, resumed);
    const double in_ripple = select(back > 0.0, select(turned > 0.0, 0.0, unloaded), 0.0);
    const double other_side = select(accord(trial, state.peak_x, state.peak_y) <= 0.0, 1.0, 0.0);
    const double crossed = select(trial.branch < far_from_reversal, other_side, 0.0);
    const double loads = select(in_ripple > 0.0, 0.0, larger(unloaded, crossed));
    count_half_cycles(turned, loads, state);
    state.active_dilation = select(loads * other_side > 0.0, state.dilation, state.active_dilation);
    state.branch = select(in_ripple > 0.0, loading_in_ripple, loading);
}

/// The middle of a substep, and the direction of the flow there.
struct Middle {
    Place place;
    double n_x, n_y; // unit vector [-]
};

inline Middle middle_of(const UbcSand& m, const Trial& trial, double number, const PlasticFlow& estimate)
{
    const Start& start = trial.start;
    const double s_end = larger(m.s_min, estimate.s), sb_end = s_end + m.a;
    const double change = half_change(start, s_end);
    const double sb = start.s * (1.0 + change) + m.a, t_end = larger(1e-6 * trial.t, estimate.t);
    const Inverses per_sb = inverses(sb_end, sb), per_t = inverses(trial.t, t_end);
    Middle middle;
    middle.place.moduli = changed_moduli(m, start.moduli, change);
    middle.place.number = number * (1.0 + m.np * change);
    middle.place.eta = 0.5 * (trial.eta_y + smaller(m.eta_f, estimate.t * per_sb.of_a));
    middle.place.sb = sb;
    middle.place.growth = sb_end * per_sb.of_b;
    // a flow that is long against the stress turns q fast: n is then where the substep ends, which is stable
    const double to_end = t_end * per_t.of_a;
    const double early = larger(0.0, 1.0 - start.moduli.G * estimate.lambda * per_t.of_b);
    const double x = early * start.q_x + trial.q_x * to_end, y = early * start.q_y + trial.q_y * to_end;
    const double per_length = 1.0 / larger(std::sqrt(x * x + y * y), 1e-300);
    middle.n_x = x * per_length;
    middle.n_y = y * per_length;
    const double along = middle.n_x * start.q_x + middle.n_y * start.q_y;
    const double t_start = early * std::sqrt(start.squared) + (1.0 - early) * along;
    const double shear = middle.n_x * trial.shear_x + middle.n_y * trial.shear_y;
    middle.place.t_trial = t_start + middle.place.moduli.G * shear;
    middle.place.s_trial = start.s + middle.place.moduli.K * trial.volumetric;
    return middle;
}

/// Where a substep ends: its flow, the direction of q and the modulus of the stress out of the plane.
struct Return {
    PlasticFlow flow;
    double q_x, q_y; // [Pa]
    double E2;       // [Pa]
};

/// The return in second order, with what stands in the middle of the substep. The stress must drag the locus;
/// else the estimate stays.
inline Return return_from_middle(const UbcSand& m, const Trial& trial, const HardeningFactors& F,
                                 double eta_max, double number)
{
    const Start& start = trial.start;
    const Place at_start = {start.moduli, number, trial.eta_y, start.sb, 1.0, trial.t, trial.s};
    const PlasticFlow estimate = flow_on_locus(m, trial, F, eta_max, at_start);
    const Middle middle = middle_of(m, trial, number, estimate);
    const PlasticFlow flow = flow_on_locus(m, trial, F, eta_max, middle.place);
    const double G = middle.place.moduli.G;
    const bool drags =
        (smaller(smaller(estimate.s, flow.s), start.s_old) >= m.s_min) & (trial.branch >= far_from_reversal);
    Return end;
    end.flow = select(drags, flow, estimate);
    end.q_x = select(drags, start.q_x + G * (trial.shear_x - flow.lambda * middle.n_x), trial.q_x);
    end.q_y = select(drags, start.q_y + G * (trial.shear_y - flow.lambda * middle.n_y), trial.q_y);
    end.E2 = select(drags, middle.place.moduli.E2, start.moduli.E2);
    return end;
}

/// The return in first order.
inline Return return_from_start(const UbcSand& m, const Trial& trial, double G_p)
{
    Return end;
    end.flow = flow_from_start(m, trial, G_p);
    end.q_x = trial.q_x;
    end.q_y = trial.q_y;
    end.E2 = trial.start.moduli.E2;
    return end;
}

/// [8] to [10] The plastic end of a substep; returns its flow.
template <Integration order>
PlasticFlow finish_plastic(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    remember_loading(m, trial, state);
    const HardeningFactors F = hardening_factors(m, trial, state);
    const double number = plastic_number(m, trial.start.s);
    const double factor = select(trial.eta_y < state.eta_max - 1e-9, F.secondary, F.virgin);
    const double G_p = factor * plastic_modulus(m, number, trial.eta_y);
    Return end;
    if constexpr (order == Integration::first_order) {
        end = return_from_start(m, trial, G_p);
    } else {
        end = return_from_middle(m, trial, F, state.eta_max, number);
    }
    PlasticFlow flow = select(end.flow.s < m.s_min, flow_at_floor(m, trial, G_p), end.flow);
    flow.t =
        larger(0.0, smaller(flow.t, m.eta_f * (flow.s + m.a))); // rounding, and substeps beyond the budget
    state.dilation += flow.dilating;                            // [9]
    const double sb = flow.s + m.a, length = larger(std::sqrt(end.q_x * end.q_x + end.q_y * end.q_y), 1e-300);
    const Inverses per = inverses(sb, length);
    state.eta_max = larger(state.eta_max, flow.t * per.of_a);
    const double sigma_z = trial.sigma_z + end.E2 * (trial.volumetric - flow.contraction);
    const double ratio = flow.t * per.of_b;
    set_stress(m, flow.s, end.q_x * ratio, end.q_y * ratio, sigma_z, state);
    return flow;
}

} // namespace quicksand::ubcsand
