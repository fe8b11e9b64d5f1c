// A plastic substep of UBCSAND in second order: q turns on its locus towards the strain while the sand flows.
//
// Turning    The elastic shear is a straight path g = G (d eps_x - d eps_y, d gamma_xy); the flow is coaxial
// with
//            q. With a constant |q| = t the angle theta between q and g obeys d theta = -(|dg|/t) sin theta,
//            so that tan(theta/2) falls by exp(-|g|/t) (Krieg and Krieg 1977), and the shear along q sums to
//            |g| + t ln R, R = (1 + cos theta)/2 + (1 - cos theta)/2 exp(-2 |g|/t), exact at any length. t is
//            the geometric mean of start and end.
// Flow       [8, 8c] with the shear along q, and the coefficients of the middle, from an estimate of the end
//            with the coefficients of the start. The locus changes its stiffness inside a substep where it
//            meets the largest ratio, and becomes the failure line where it meets that.
// Error      The difference of the end and its estimate.
#pragma once

#include "solver/ubcsand/ubcsand_flow.hpp"

namespace quicksand::ubcsand {

/// A stress that turns: the elastic shear along it, and its direction in the end.
struct Turning {
    double along;    // [Pa]
    double n_x, n_y; // unit vector [-]
};

/// Turn q towards an elastic shear g while its size is t [Pa].
inline Turning turn_towards(const Start& start, double t_start, const Deviator& g, double t)
{
    constexpr double least = 1e-150, log2_e = 1.442695040888963407, ln_2 = 0.693147180559945309;
    const double size = larger(std::sqrt(g.x * g.x + g.y * g.y), least);
    const Inverses per = inverses(larger(t_start, least), size);
    const double psi = smaller(300.0, size / larger(t, least)); // beyond, q has the direction of g
    const double n_x = start.q_x * per.of_a, n_y = start.q_y * per.of_a;
    const double g_x = g.x * per.of_b, g_y = g.y * per.of_b;
    const double cosine = larger(-1.0, smaller(1.0, n_x * g_x + n_y * g_y));
    const double shrinks = exponential_2(-log2_e * psi);
    const double towards = larger(1e-12, 0.5 + 0.5 * cosine);
    const double against = (0.5 - 0.5 * cosine) * (shrinks * shrinks);
    const double R = towards + against, per_R = 1.0 / R;
    const double of_q = shrinks * per_R, of_g = (towards - against) * per_R - cosine * of_q;
    return {size + t * (ln_2 * logarithm_2(R)), of_q * n_x + of_g * g_x, of_q * n_y + of_g * g_y};
}

/// Where a substep ends.
struct Return {
    PlasticFlow flow;
    double n_x, n_y; // direction of q, a unit vector [-]
    double E2;       // of the stress out of the plane [Pa]
    double error;    // of the stress [Pa]
};

/// The difference of two ends of a substep. At the floor they are the same, as far below it as they may be.
inline double difference(const UbcSand& m, const PlasticFlow& a, const Turning& at_a, const PlasticFlow& b,
                         const Turning& at_b)
{
    const double below = larger(0.0, m.s_min - larger(a.s, b.s));
    const double ds = larger(0.0, std::abs(a.s - b.s) - below);
    const double t_a = smaller(a.t, m.eta_f * (larger(m.s_min, a.s) + m.a));
    const double t_b = smaller(b.t, m.eta_f * (larger(m.s_min, b.s) + m.a));
    const double x = t_a * at_a.n_x - t_b * at_b.n_x, y = t_a * at_a.n_y - t_b * at_b.n_y;
    return std::sqrt(ds * ds + x * x + y * y);
}

/// The middle of a substep whose end is estimated, but for the trial there.
inline Place middle_of(const UbcSand& m, const Trial& trial, double number, const PlasticFlow& estimate)
{
    const double s_end = larger(m.s_min, estimate.s), sb_end = s_end + m.a;
    const double change = half_change(trial.start, s_end);
    const double sb = trial.start.s * (1.0 + change) + m.a;
    const Inverses per = inverses(sb_end, sb);
    Place middle;
    middle.moduli = changed_moduli(m, trial.start.moduli, change);
    middle.number = number * (1.0 + m.np * change);
    middle.eta = 0.5 * (trial.eta_y + smaller(m.eta_f, larger(0.0, estimate.t) * per.of_a));
    middle.sb = sb;
    middle.growth = sb_end * per.of_b;
    middle.s_trial = trial.start.s + middle.moduli.K * trial.volumetric;
    return middle;
}

/// The return in second order.
inline Return return_turning(const UbcSand& m, const Trial& trial, const HardeningFactors& F, double eta_max,
                             double number)
{
    const Start& start = trial.start;
    const double t_start = std::sqrt(start.squared), G = start.moduli.G;
    const Turning first = turn_towards(start, t_start, {G * trial.shear_x, G * trial.shear_y}, t_start);
    const double s_trial = start.s + start.moduli.K * trial.volumetric;
    const Place at_start = {start.moduli, number, trial.eta_y, start.sb, 1.0, t_start + first.along, s_trial};
    const PlasticFlow estimate = flow_on_locus(m, trial, F, eta_max, at_start);

    Place middle = middle_of(m, trial, number, estimate);
    const double G_middle = middle.moduli.G, mean = std::sqrt(t_start * larger(0.0, estimate.t));
    const Turning second =
        turn_towards(start, t_start, {G_middle * trial.shear_x, G_middle * trial.shear_y}, mean);
    middle.t_trial = t_start + second.along;
    Return end;
    end.flow = flow_on_locus(m, trial, F, eta_max, middle);
    end.n_x = second.n_x;
    end.n_y = second.n_y;
    end.E2 = middle.moduli.E2;
    end.error = difference(m, estimate, first, end.flow, second);
    return end;
}

/// [8] to [10] The plastic end of a substep of second order; returns its flow, and the error of the stress
/// [Pa].
template <Locking locking>
inline PlasticFlow finish_in_second_order(const UbcSand& m, const Trial& trial, UbcSandState& state,
                                          double& error)
{
    constexpr Integration order = Integration::second_order;
    remember_loading<order>(m, trial, state);
    const HardeningFactors F = hardening_factors<locking>(m, at_middle<order>(trial), state);
    const double number = plastic_number(m, trial.start.s);
    const Return end = return_turning(m, trial, F, state.eta_max, number);
    const double G_p = modulus_of_locus(m, trial, F, number, state);
    PlasticFlow flow = select(end.flow.s < m.s_min, flow_at_floor(m, trial, G_p), end.flow);
    finish_flow(m, trial, {end.n_x, end.n_y}, end.E2, flow, state);
    error = end.error;
    return flow;
}

} // namespace quicksand::ubcsand
