// One substep of UBCSAND, equation by equation: straight lines of arithmetic that a single point and a vector
// of points share, so that both give the same bits.
//
// Symbols    s = (sigma_x + sigma_y)/2, q = ((sigma_x - sigma_y)/2, tau_xy), t = |q|
//            a = c cot phi_f, sb = s + a, r = q/sb, eta = t/sb = sin of the mobilised friction angle
//            lambda = plastic shear strain, D = sin phi_cv - eta = plastic contraction per lambda
//            K' = B + G/3, E1 = B + 4G/3, E2 = B - 2G/3
// Units/signs  Pa; stress and strain are compression positive in here, shear strain is engineering shear.
// Numbers    [1] to [10] are the steps of the algorithm as the docstring of `update` lists them.
#pragma once

#include "solver/conventions.hpp"
#include "solver/ubcsand.hpp"
#include "solver/ubcsand_power.hpp"

#include <cmath>

namespace quicksand::ubcsand {

/// Where a point is on its branch: doubles, so that vectors hold one kind of number. Unloading that has just
/// begun may be an excursion of the loading before, until the stress ratio has gone the tolerance from there.
inline constexpr double just_reversed = 0.0, far_from_reversal = 1.0, loading = 2.0;

/// What the reversals of the strain and the beginnings of loading owe each other, a half cycle for each pair.
inline constexpr double loading_waits = -1.0, even = 0.0, reversal_waits = 1.0;

/// Both branches are evaluated in a vector; a name for that.
inline double select(bool condition, double yes, double no)
{
    return condition ? yes : no;
}
inline double larger(double a, double b)
{
    return a > b ? a : b;
}
inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

struct Rotation {
    double cosine, sine; // of twice the angle: deviators turn so [-]
};

/// [1] The rotation of a spin, tan(angle/2) = spin/2.
inline Rotation rotation_of(double spin)
{
    const double h = 0.5 * spin;
    const double scale = 1.0 / (1.0 + h * h);
    const double c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
    return {c * c - s * s, 2.0 * s * c};
}

inline void turn_stress(const Rotation& turn, UbcSandState& state)
{
    const double s = 0.5 * (state.sigma_x + state.sigma_y), q_x = 0.5 * (state.sigma_x - state.sigma_y);
    const double turned = turn.cosine * q_x - turn.sine * state.tau_xy;
    state.tau_xy = turn.sine * q_x + turn.cosine * state.tau_xy;
    state.sigma_x = s + turned;
    state.sigma_y = s - turned;
}

inline void turn_vector(const Rotation& turn, double& x, double& y)
{
    const double turned = turn.cosine * x - turn.sine * y;
    y = turn.sine * x + turn.cosine * y;
    x = turned;
}

inline void turn_memory(const Rotation& turn, UbcSandState& state)
{
    turn_vector(turn, state.peak_x, state.peak_y);
    turn_vector(turn, state.origin_x, state.origin_y);
    turn_vector(turn, state.leg_x, state.leg_y);
    turn_vector(turn, state.back_x, state.back_y);
}

struct Moduli {
    double G, E1, E2, K; // [Pa]
};

/// [3] Elastic moduli at a mean stress. `square_roots`: both exponents are 1/2, as in the generic set.
template <bool square_roots>
Moduli elastic_moduli(const UbcSand& m, double s)
{
    const double ratio = s * (1.0 / atmospheric_pressure);
    double G, B;
    if constexpr (square_roots) {
        const double root = std::sqrt(ratio);
        G = m.G_atm * root;
        B = m.B_atm * root;
    } else {
        G = m.G_atm * power(ratio, m.ne);
        B = m.B_atm * power(ratio, m.me);
    }
    return {G, B + G * (4.0 / 3.0), B - G * (2.0 / 3.0), B + G * (1.0 / 3.0)};
}

struct Strain {
    double x, y, xy; // [-]
};

/// Most substeps of one update: an absurd strain is then taken in larger ones, stable but coarse. [-]
inline constexpr double most_substeps = 100000.0;

/// [2] Number of substeps for the strain that remains: each moves the stress ratio and, relatively, the mean
/// stress by at most the given steps, were it elastic. Below the resolved stress it may move the stresses by
/// as much as there: in liquefied sand the ratios change at the least strain, but the stresses hardly.
inline double substep_count(const UbcSand& m, const Moduli& moduli, double s, const Strain& strain,
                            double budget)
{
    const double difference = strain.x - strain.y;
    const double shear = std::sqrt(difference * difference + strain.xy * strain.xy);
    const double resolved = larger(s, m.resolved), sb = resolved + m.a;
    const double by_ratio = moduli.G * shear * m.per_ratio_step * resolved;
    const double by_volume = moduli.K * std::abs(strain.x + strain.y) * m.per_stress_step * sb;
    const double demand = smaller(larger(by_ratio, by_volume) / (resolved * sb), budget);
    // round up: adding 1.5 x 2^52 rounds to the nearest
    constexpr double shift = 0x1.8p52;
    const double nearest = (demand + shift) - shift;
    return larger(1.0, nearest + select(nearest < demand, 1.0, 0.0));
}

struct Substep {
    Moduli moduli;
    Strain strain;
    bool last;
};

/// [2, 3] Take the next substep off the strain that remains.
template <bool square_roots>
Substep next_substep(const UbcSand& m, const UbcSandState& state, double budget, Strain& remaining)
{
    const double s = larger(0.5 * (state.sigma_x + state.sigma_y), m.s_min);
    Substep substep;
    substep.moduli = elastic_moduli<square_roots>(m, s);
    const double count = substep_count(m, substep.moduli, s, remaining, budget);
    const double share = 1.0 / count;
    substep.strain = {remaining.x * share, remaining.y * share, remaining.xy * share};
    substep.last = count <= 1.0;
    remaining = {remaining.x - substep.strain.x, remaining.y - substep.strain.y,
                 remaining.xy - substep.strain.xy};
    return substep;
}

/// What an elastic substep would give, and whether the locus stands in its way.
struct Trial {
    Moduli moduli;
    double s;           // not below the floor [Pa]
    double q_x, q_y, t; // [Pa]
    double sigma_z;     // [Pa]
    double strain_x;    // eps_x - eps_y of the substep [-]
    double strain_y;    // its shear strain [-]
    double eta_y;       // ratio of the locus [-]
    double r_x, r_y;    // before the substep [-]
    double branch;      // before the substep, with the departure from where it turned noticed
    double scale;       // s_min or s before the substep, over P_a [-]
    bool plastic;
};

/// [5] Ratio of the yield locus: the present one in loading and on a branch that has left its reversal, the
/// one at the reversal for a tiny excursion.
inline void place_locus(const UbcSand& m, const UbcSandState& state, Trial& trial)
{
    const double away_x = trial.r_x - state.peak_x, away_y = trial.r_y - state.peak_y;
    const double departed =
        select(away_x * away_x + away_y * away_y >= m.tolerance_squared, far_from_reversal, just_reversed);
    trial.branch = select(state.branch == just_reversed, departed, state.branch);
    const double eta_squared = trial.r_x * trial.r_x + trial.r_y * trial.r_y;
    const double peak_squared = state.peak_x * state.peak_x + state.peak_y * state.peak_y;
    const double held = select(trial.branch == just_reversed, larger(eta_squared, peak_squared), eta_squared);
    trial.eta_y = smaller(std::sqrt(held), m.eta_f);
}

/// [3] to [7] up to the decision.
inline Trial elastic_trial(const UbcSand& m, const UbcSandState& state, const Moduli& moduli,
                           const Strain& strain)
{
    Trial trial;
    trial.moduli = moduli;
    const double s = larger(0.5 * (state.sigma_x + state.sigma_y), m.s_min);
    const double q_x = 0.5 * (state.sigma_x - state.sigma_y), q_y = state.tau_xy;
    const double per_stress = 1.0 / (s + m.a);
    trial.r_x = q_x * per_stress;
    trial.r_y = q_y * per_stress;
    trial.scale = s * (1.0 / atmospheric_pressure);

    // [4] d s = K' d eps_v, d q = G (d eps_x - d eps_y, d gamma_xy); s as it is, be it below the floor
    const double volumetric = strain.x + strain.y, difference = strain.x - strain.y;
    const double s_old = 0.5 * (state.sigma_x + state.sigma_y);
    trial.strain_x = difference;
    trial.strain_y = strain.xy;
    trial.q_x = q_x + moduli.G * difference;
    trial.q_y = q_y + moduli.G * strain.xy;
    trial.t = std::sqrt(trial.q_x * trial.q_x + trial.q_y * trial.q_y);
    trial.sigma_z = state.sigma_z + moduli.E2 * volumetric;
    trial.s = larger(s_old + moduli.K * volumetric, m.s_min); // [6]
    place_locus(m, state, trial);                             // [5]
    trial.plastic = trial.t > trial.eta_y * (trial.s + m.a);  // [7]
    return trial;
}

/// [10] Stress from s and the trial's q times `ratio`, t over the trial's t.
inline void rebuild_stress(const UbcSand& m, const Trial& trial, double s, double ratio, double sigma_z,
                           UbcSandState& state)
{
    const double q_x = trial.q_x * ratio;
    state.sigma_x = s + q_x;
    state.sigma_y = s - q_x;
    state.sigma_z = larger(sigma_z, 0.2 * m.s_min);
    state.tau_xy = trial.q_y * ratio;
}

/// Of the longer of the present leg of the strain and the last one, which a reversal must go back.
inline constexpr double least_share_of_a_leg = 0.25; // [-]

/// Follow the strain in its plane of shear: the leg goes from where it last turned to the farthest point
/// since; it has turned again when the strain has gone the ripple's strain, or a share of the leg if that is
/// less, back from the farthest point. Without a ripple's strain every substep counts as a turn. Returns 1
/// for a turn, else 0.
inline double follow_strain(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    const double back_x = state.back_x + trial.strain_x, back_y = state.back_y + trial.strain_y;
    const double all_x = state.leg_x + back_x, all_y = state.leg_y + back_y;
    const double leg = state.leg_x * state.leg_x + state.leg_y * state.leg_y;
    const double back = back_x * back_x + back_y * back_y;
    const double share = least_share_of_a_leg * least_share_of_a_leg * larger(leg, state.last_leg);
    const double least = smaller(m.ripple_squared, share);
    const double farther = select(all_x * all_x + all_y * all_y >= leg, 1.0, 0.0);
    const double turned = select(farther > 0.0, 0.0, select(back >= least, 1.0, 0.0));
    state.last_leg = select(turned > 0.0, leg, state.last_leg);
    state.leg_x = select(turned > 0.0, back_x, select(farther > 0.0, all_x, state.leg_x));
    state.leg_y = select(turned > 0.0, back_y, select(farther > 0.0, all_y, state.leg_y));
    state.back_x = select(turned + farther > 0.0, 0.0, back_x);
    state.back_y = select(turned + farther > 0.0, 0.0, back_y);
    return select(m.ripple_squared <= 0.0, 1.0, turned);
}

/// A half cycle is a reversal of the strain and a beginning of loading, whichever comes first; both are 1 or
/// 0. The reversal makes where the stress turned the origin of the present branch.
inline void count_half_cycles(double turned, double loads, UbcSandState& state)
{
    const double began = select(state.waiting == even, reversal_waits, state.waiting);
    const double waiting = select(turned > 0.0, began, state.waiting);
    const double counts = select(waiting > even, loads, select(waiting < even, turned, 0.0));
    state.half_cycles += counts;
    state.active_dilation = select(counts > 0.0, state.dilation, state.active_dilation);
    state.waiting = select(counts > 0.0, even, select(loads > 0.0, loading_waits, waiting));
    state.origin_x = select(turned > 0.0, state.peak_x, state.origin_x);
    state.origin_y = select(turned > 0.0, state.peak_y, state.origin_y);
}

/// Not positive when the trial's stress is on the other side of the isotropic axis than r.
inline double accord(const Trial& trial, double r_x, double r_y)
{
    return trial.q_x * r_x + trial.q_y * r_y;
}

/// [7] The elastic end: the first elastic substep after loading is a reversal, which is remembered.
inline void finish_elastic(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    const bool reversal = trial.branch == loading;
    state.peak_x = select(reversal, trial.r_x, state.peak_x);
    state.peak_y = select(reversal, trial.r_y, state.peak_y);
    state.branch = select(reversal, just_reversed, trial.branch);
    count_half_cycles(follow_strain(m, trial, state), 0.0, state);
    rebuild_stress(m, trial, trial.s, 1.0, trial.sigma_z, state);
}

/// [8a, 8b] F: stiff on secondary loading, soft after a dilation once the branch has crossed the isotropic
/// axis.
inline double hardening_factor(const UbcSand& m, const Trial& trial, const UbcSandState& state)
{
    const bool secondary = trial.eta_y < state.eta_max - 1e-9;
    const double F = select(secondary, m.h1 * m.h2 * (m.s0 + m.s1 * state.half_cycles), m.h1);
    const double least_accord =
        smaller(accord(trial, state.origin_x, state.origin_y), accord(trial, state.peak_x, state.peak_y));
    const double loss = larger(-1000.0, -m.a_dil_log2 * state.active_dilation); // exp as a power of 2
    const double softened = larger(m.fac_post, F * exponential_2(loss));
    return select(least_accord <= 0.0, select(state.active_dilation > 0.0, softened, F), F);
}

/// G^p = F K_G^p P_a (s/P_a)^np (1 - R_f eta/eta_f)^2
inline double plastic_modulus(const UbcSand& m, const Trial& trial, double F)
{
    const double u = 1.0 - m.R * trial.eta_y;
    return F * m.Gp_atm * power(trial.scale, m.np) * (u * u);
}

struct PlasticFlow {
    double s, t;   // after the return [Pa]
    double lambda; // plastic shear strain [-]
    double D;      // plastic contraction per plastic shear strain [-]
};

/// [8] Return to the hardened locus:  lambda = (t - eta_y sb)/(G + G^p - eta_y K' D), ds = -K' D lambda,
/// dt = -G lambda.
inline PlasticFlow flow_on_locus(const UbcSand& m, const Trial& trial, double G_p)
{
    const double G = trial.moduli.G, K = trial.moduli.K;
    const double D = m.sin_cv - trial.eta_y;
    const double lambda = (trial.t - trial.eta_y * (trial.s + m.a)) / (G + G_p - trial.eta_y * K * D);
    return {trial.s - K * D * lambda, trial.t - G * lambda, lambda, D};
}

/// [8c] Return to the failure line, perfectly plastic.
inline PlasticFlow flow_at_failure(const UbcSand& m, const Trial& trial)
{
    const double G = trial.moduli.G, K = trial.moduli.K;
    const double D = m.sin_cv - m.eta_f;
    const double lambda = larger(0.0, (trial.t - m.eta_f * (trial.s + m.a)) / (G - m.eta_f * K * D));
    return {trial.s - K * D * lambda, trial.t - G * lambda, lambda, D};
}

/// [8d] Shear at the stress floor: constant s, so that dilation can later lift the point off it.
inline PlasticFlow flow_at_floor(const UbcSand& m, const Trial& trial, double G_p)
{
    const double G = trial.moduli.G, sb = m.s_min + m.a;
    const double lambda = larger(0.0, (trial.t - trial.eta_y * sb) / (G + G_p));
    return {m.s_min, smaller(trial.t - G * lambda, m.eta_f * sb), lambda, 0.0};
}

inline PlasticFlow select(bool condition, const PlasticFlow& yes, const PlasticFlow& no)
{
    return {select(condition, yes.s, no.s), select(condition, yes.t, no.t),
            select(condition, yes.lambda, no.lambda), select(condition, yes.D, no.D)};
}

/// [8] to [10] The plastic end of a substep; returns its flow.
inline PlasticFlow finish_plastic(const UbcSand& m, const Trial& trial, UbcSandState& state)
{
    const double loads = select(trial.branch == far_from_reversal, 1.0, 0.0);
    count_half_cycles(follow_strain(m, trial, state), loads, state);
    const double other_sense = select(accord(trial, state.peak_x, state.peak_y) <= 0.0, loads, 0.0);
    state.active_dilation = select(other_sense > 0.0, state.dilation, state.active_dilation);
    state.branch = loading;
    const double G_p = plastic_modulus(m, trial, hardening_factor(m, trial, state));
    PlasticFlow flow = flow_on_locus(m, trial, G_p);
    flow = select(flow.t > m.eta_f * (flow.s + m.a), flow_at_failure(m, trial), flow);
    flow = select(flow.s < m.s_min, flow_at_floor(m, trial, G_p), flow);
    flow.t =
        larger(0.0, smaller(flow.t, m.eta_f * (flow.s + m.a))); // rounding, and substeps beyond the budget
    state.dilation += select(flow.D < 0.0, flow.lambda, 0.0);   // [9]
    state.eta_max = larger(state.eta_max, flow.t / (flow.s + m.a));
    const double sigma_z = trial.sigma_z - trial.moduli.E2 * flow.D * flow.lambda;
    rebuild_stress(m, trial, flow.s, flow.t / trial.t, sigma_z, state);
    return flow;
}

} // namespace quicksand::ubcsand
