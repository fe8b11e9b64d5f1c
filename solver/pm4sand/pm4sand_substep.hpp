// A substep of PM4Sand: elastic to the yield surface, then plastic in second order, with an estimate of its
// error.
//
// Yield      |s - p alpha| = m p/2, a small circle. The elastic path is a straight line of s and p with the
// mean of
//            the moduli at its ends; where it leaves the circle is a quadratic equation.
// Reversal   Plastic flow against the way since alpha_in, (alpha - alpha_in):n < 0, is a new beginning. The
// published
//            programs ask the trial stress also inside the circle; here an excursion that does not yield is
//            forgotten, for a run's strains have ripples.
// Flow       dp = K1 d eps_v - K D lambda, ds = G (d eps_x - d eps_y, d gamma_xy) - G lambda u, K1 = K + G/3,
// with
//            lambda = (G g.u - r.u K1 d eps_v) / (G + K_p/2 - K D r.u). The report has K in the place of K1,
//            which is the rate of the mean stress in the plane: with K1 the stress stays on the circle.
// Two orders Heun's rule of the rates at start and end; half their difference is the error [Sloan et al.
// 2001]. What is
//            left of a distance to the circle goes to alpha.
// Floor      The mean stress is at least p_min/5; what would go below opens the grains without stress.
#pragma once

#include "solver/pm4sand/pm4sand_flow.hpp"

namespace quicksand::pm4sand {

inline constexpr double floor_factor = 0.2; // of p_min, the least mean stress [-]

/// A strain as what it does: shear (eps_x - eps_y, gamma_xy) and volume, compression positive.
struct Strain {
    double x, y, volumetric; // [-]
};

inline Strain part_of(const Strain& strain, double fraction)
{
    return {fraction * strain.x, fraction * strain.y, fraction * strain.volumetric};
}

inline Point point_of(const Pm4SandState& state)
{
    return {0.5 * (state.sigma_x + state.sigma_y),
            0.5 * (state.sigma_x - state.sigma_y),
            state.tau_xy,
            state.sigma_z,
            state.alpha_x,
            state.alpha_y,
            state.fabric_x,
            state.fabric_y,
            state.fabric_path,
            state.void_ratio};
}

inline void set_point(const Point& at, Pm4SandState& state)
{
    state.sigma_x = at.p + at.s_x;
    state.sigma_y = at.p - at.s_x;
    state.tau_xy = at.s_y;
    state.sigma_z = at.sigma_z;
    state.alpha_x = at.alpha_x, state.alpha_y = at.alpha_y;
    state.fabric_x = at.fabric_x, state.fabric_y = at.fabric_y;
    state.fabric_path = at.fabric_path;
    state.void_ratio = at.void_ratio;
}

/// a + w d for what changes.
inline Point sum(const Point& a, double w, const Point& d)
{
    return {a.p + w * d.p,
            a.s_x + w * d.s_x,
            a.s_y + w * d.s_y,
            a.sigma_z + w * d.sigma_z,
            a.alpha_x + w * d.alpha_x,
            a.alpha_y + w * d.alpha_y,
            a.fabric_x + w * d.fabric_x,
            a.fabric_y + w * d.fabric_y,
            a.fabric_path + w * d.fabric_path,
            a.void_ratio + w * d.void_ratio};
}

inline Point select(bool condition, const Point& yes, const Point& no)
{
    return {select(condition, yes.p, no.p),
            select(condition, yes.s_x, no.s_x),
            select(condition, yes.s_y, no.s_y),
            select(condition, yes.sigma_z, no.sigma_z),
            select(condition, yes.alpha_x, no.alpha_x),
            select(condition, yes.alpha_y, no.alpha_y),
            select(condition, yes.fabric_x, no.fabric_x),
            select(condition, yes.fabric_y, no.fabric_y),
            select(condition, yes.fabric_path, no.fabric_path),
            select(condition, yes.void_ratio, no.void_ratio)};
}

inline Pm4SandState select(bool condition, const Pm4SandState& yes, const Pm4SandState& no)
{
    return {select(condition, yes.sigma_x, no.sigma_x),
            select(condition, yes.sigma_y, no.sigma_y),
            select(condition, yes.sigma_z, no.sigma_z),
            select(condition, yes.tau_xy, no.tau_xy),
            select(condition, yes.alpha_x, no.alpha_x),
            select(condition, yes.alpha_y, no.alpha_y),
            select(condition, yes.start_x, no.start_x),
            select(condition, yes.start_y, no.start_y),
            select(condition, yes.turn_x, no.turn_x),
            select(condition, yes.turn_y, no.turn_y),
            select(condition, yes.previous_x, no.previous_x),
            select(condition, yes.previous_y, no.previous_y),
            select(condition, yes.least_x, no.least_x),
            select(condition, yes.least_y, no.least_y),
            select(condition, yes.most_x, no.most_x),
            select(condition, yes.most_y, no.most_y),
            select(condition, yes.fabric_x, no.fabric_x),
            select(condition, yes.fabric_y, no.fabric_y),
            select(condition, yes.origin_x, no.origin_x),
            select(condition, yes.origin_y, no.origin_y),
            select(condition, yes.fabric_path, no.fabric_path),
            select(condition, yes.fabric_peak, no.fabric_peak),
            select(condition, yes.peak_stress, no.peak_stress),
            select(condition, yes.peak_product, no.peak_product),
            select(condition, yes.void_ratio, no.void_ratio),
            select(condition, yes.fabric_limit, no.fabric_limit),
            select(condition, yes.dilatancy_factor, no.dilatancy_factor),
            select(condition, yes.least_stress, no.least_stress)};
}

/// Raise the mean stress to the floor; the stress then lies within its circle.
inline void limit_to_floor(const Pm4Sand& m, const Pm4SandState& memory, Point& at)
{
    const double floor = floor_factor * memory.least_stress;
    const bool below = at.p < floor;
    const double w_x = at.s_x - floor * at.alpha_x, w_y = at.s_y - floor * at.alpha_y;
    const double radius = 0.5 * m.yield_radius * floor;
    const double scale = radius / larger(radius, std::sqrt(w_x * w_x + w_y * w_y));
    at.s_x = select(below, floor * at.alpha_x + scale * w_x, at.s_x);
    at.s_y = select(below, floor * at.alpha_y + scale * w_y, at.s_y);
    at.p = select(below, floor, at.p);
    at.sigma_z = larger(at.sigma_z, floor);
}

/// The elastic change of a strain with a shear modulus G.
inline Point elastic_change(const Pm4Sand& m, const Point& at, double G, const Strain& strain)
{
    const double K = m.bulk_over_shear * G, v = strain.volumetric;
    return {(K + G / 3.0) * v,
            G * strain.x,
            G * strain.y,
            (K - 2.0 / 3.0 * G) * v,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            -(1.0 + at.void_ratio) * v};
}

inline double elastic_modulus(const Pm4Sand& m, const Pm4SandState& memory, const Point& at)
{
    const double p = larger(at.p, memory.least_stress);
    const double q = 2.0 * std::sqrt(at.s_x * at.s_x + at.s_y * at.s_y);
    const Surfaces on = surfaces_at(m, p, q, at.void_ratio);
    return shear_modulus_at(m, on, p, at.p, at.fabric_path / memory.fabric_limit);
}

/// The part of an elastic path inside the yield surface: 1 where all of it is [-].
inline double elastic_part(const Pm4Sand& m, const Point& from, const Point& change)
{
    const double w_x = from.s_x - from.p * from.alpha_x, w_y = from.s_y - from.p * from.alpha_y;
    const double d_x = change.s_x - change.p * from.alpha_x, d_y = change.s_y - change.p * from.alpha_y;
    const double half = 0.5 * m.yield_radius, rho = half * from.p, d_rho = half * change.p;
    const double A = d_x * d_x + d_y * d_y - d_rho * d_rho, B = w_x * d_x + w_y * d_y - rho * d_rho;
    const double C = smaller(0.0, w_x * w_x + w_y * w_y - rho * rho);
    const double root = std::sqrt(larger(0.0, B * B - A * C));
    const bool outward = B > 0.0;
    const double way = select(outward, -C, root - B) / select(outward, B + root, larger(A, 1e-300));
    return select(A + 2.0 * B + C > 0.0, smaller(1.0, way), 1.0);
}

/// A unit vector along the distance to the centre of the yield surface; (0, 1) at the centre.
struct Direction {
    double x, y;
};
inline Direction direction_of(const Point& at)
{
    const double w_x = at.s_x - at.p * at.alpha_x, w_y = at.s_y - at.p * at.alpha_y;
    const double size = std::sqrt(w_x * w_x + w_y * w_y);
    const double per_size = 1.0 / larger(size, 1e-200);
    return {w_x * per_size, select(size > 1e-200, w_y * per_size, 1.0)};
}

/// The change of a plastic strain at the rates of a point.
inline Point plastic_change(const Pm4Sand& m, const Pm4SandState& memory, const Point& given,
                            const Strain& strain)
{
    Point at = given;
    limit_to_floor(m, memory, at);
    const Direction u = direction_of(at);
    const Flow flow = flow_at(m, memory, at, u.x, u.y);
    Point change = elastic_change(m, at, flow.G, strain);
    const double per_p = 1.0 / at.p, ratio = (at.s_x * u.x + at.s_y * u.y) * per_p;
    const double driven = change.s_x * u.x + change.s_y * u.y - ratio * change.p;
    const double lambda = positive(driven) / flow.resistance;
    change.p -= flow.K * flow.D * lambda;
    change.sigma_z -= flow.K * flow.D * lambda;
    change.s_x -= flow.G * lambda * u.x;
    change.s_y -= flow.G * lambda * u.y;
    change.alpha_x = flow.alpha_x * per_p * lambda;
    change.alpha_y = flow.alpha_y * per_p * lambda;
    change.fabric_x = flow.fabric_x * lambda;
    change.fabric_y = flow.fabric_y * lambda;
    change.fabric_path = std::sqrt(change.fabric_x * change.fabric_x + change.fabric_y * change.fabric_y);
    return change;
}

/// Loading that begins anew: alpha_in and what else is remembered of the reversal.
inline void remember_reversal(const Point& at, const Direction& u, Pm4SandState& memory)
{
    const double since = (at.alpha_x - memory.turn_x) * u.x + (at.alpha_y - memory.turn_y) * u.y;
    const bool reverses = since < 0.0;
    const auto set = [&](double& number, double value) { number = select(reverses, value, number); };
    const double p = larger(at.p, memory.least_stress);
    const double product = root_2 * std::sqrt(at.fabric_x * at.fabric_x + at.fabric_y * at.fabric_y) * p;
    const bool largest = (product > memory.peak_product) & (p > memory.peak_stress);
    set(memory.peak_stress, select(largest, p, memory.peak_stress));
    set(memory.peak_product, select(largest, product, memory.peak_product));
    set(memory.origin_x, at.fabric_x), set(memory.origin_y, at.fabric_y);
    set(memory.turn_x, at.alpha_x), set(memory.turn_y, at.alpha_y);
    const double before_x = memory.start_x, before_y = memory.start_y;
    set(memory.previous_x, before_x), set(memory.previous_y, before_y);
    set(memory.least_x, select(before_x > 0.0, smaller(memory.least_x, at.alpha_x), memory.least_x));
    set(memory.least_y, select(before_y > 0.0, smaller(memory.least_y, at.alpha_y), memory.least_y));
    set(memory.most_x, select(before_x > 0.0, memory.most_x, larger(memory.most_x, at.alpha_x)));
    set(memory.most_y, select(before_y > 0.0, memory.most_y, larger(memory.most_y, at.alpha_y)));
    const bool stays = at.alpha_y * before_y > 0.0; // the shear does not change its sign
    const double apparent_x = select(u.x > 0.0, positive(memory.least_x), smaller(0.0, memory.most_x));
    const double apparent_y = select(u.y > 0.0, positive(memory.least_y), smaller(0.0, memory.most_y));
    set(memory.start_x, select(stays, apparent_x, at.alpha_x));
    set(memory.start_y, select(stays, apparent_y, at.alpha_y));
}

/// A long substep carries the fabric no farther than it ever gets.
inline void limit_fabric(const Pm4SandState& memory, Point& at)
{
    const double most = memory.fabric_limit / root_2;
    const double size = std::sqrt(at.fabric_x * at.fabric_x + at.fabric_y * at.fabric_y);
    const double scale = most / larger(most, size);
    at.fabric_x *= scale, at.fabric_y *= scale;
}

/// Sand bears no tension: q/p is at most 2. A substep that loses most of the mean stress would leave the
/// shear stress, and with it the back stress, at any multiple of it.
inline void limit_to_compression(Point& at)
{
    const double half_q = std::sqrt(at.s_x * at.s_x + at.s_y * at.s_y);
    const double scale = at.p / larger(at.p, half_q);
    at.s_x *= scale, at.s_y *= scale;
}

/// What is left of a distance to the yield surface goes to its centre.
inline void return_to_surface(const Pm4Sand& m, Point& at)
{
    const double per_p = 1.0 / at.p;
    const Direction u = direction_of(at);
    at.alpha_x = at.s_x * per_p - 0.5 * m.yield_radius * u.x;
    at.alpha_y = at.s_y * per_p - 0.5 * m.yield_radius * u.y;
}

/// Where the elastic part of a strain ends.
struct Contact {
    Point at;
    double elastic; // part of the strain, 1 where it does not yield [-]
    double error;   // of the stress [Pa]
};

inline Contact reach_surface(const Pm4Sand& m, const Pm4SandState& state, const Strain& strain)
{
    const Point start = point_of(state);
    const double G_start = elastic_modulus(m, state, start);
    const Point end = sum(start, 1.0, elastic_change(m, start, G_start, strain));
    const double G = 0.5 * (G_start + elastic_modulus(m, state, end));
    const Point change = elastic_change(m, start, G, strain);
    Contact contact;
    contact.elastic = elastic_part(m, start, change);
    contact.at = sum(start, contact.elastic, change);
    limit_to_floor(m, state, contact.at);
    const double size = std::sqrt(change.p * change.p + change.s_x * change.s_x + change.s_y * change.s_y);
    contact.error = contact.elastic * std::abs(1.0 - G_start / G) * size;
    return contact;
}

/// Where a substep ends.
struct End {
    Point at;
    double error; // of the stress, relative to it [-]
};

/// The end of a substep whose plastic part changes the contact by `first` at the rates of its start. The
/// memory is that after the contact.
inline End finish(const Pm4Sand& m, const Pm4SandState& memory, const Contact& contact, const Point& first,
                  const Strain& strain)
{
    const Strain rest = part_of(strain, 1.0 - contact.elastic);
    const Point second = plastic_change(m, memory, sum(contact.at, 1.0, first), rest);
    Point flown = sum(sum(contact.at, 0.5, first), 0.5, second);
    const double d_p = second.p - first.p, d_x = second.s_x - first.s_x, d_y = second.s_y - first.s_y;
    limit_to_floor(m, memory, flown);
    limit_to_compression(flown);
    limit_fabric(memory, flown);
    return_to_surface(m, flown);
    const bool flows = contact.elastic < 1.0;
    const double error =
        contact.error + select(flows, 0.5 * std::sqrt(d_p * d_p + d_x * d_x + d_y * d_y), 0.0);
    return {select(flows, flown, contact.at), error / larger(flown.p, memory.least_stress)};
}

/// The state at the end.
inline Pm4SandState state_at(const End& end, bool flows, const Pm4SandState& memory,
                             const Pm4SandState& before)
{
    Pm4SandState state = select(flows, memory, before);
    set_point(end.at, state);
    const double size = std::sqrt(end.at.fabric_x * end.at.fabric_x + end.at.fabric_y * end.at.fabric_y);
    state.fabric_peak = larger(state.fabric_peak, size);
    return state;
}

} // namespace quicksand::pm4sand
