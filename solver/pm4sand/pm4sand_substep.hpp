// A substep of PM4Sand: elastic to the yield surface, then plastic in second order, with an estimate of its
// error.
//
// Yield: |s - p alpha| = m p/2, a small circle. The elastic path is a straight line of s and p with the mean
// of the moduli at its ends; where it leaves the circle is a quadratic equation.
// Reversal: plastic flow against the way since alpha_in, (alpha - alpha_in):n < 0, is a new beginning. The
// published programs ask the trial stress also inside the circle; here an excursion that does not yield is
// forgotten, for a run's strains have ripples.
// Two orders: Heun's rule of the changes by the rates at start and end (pm4sand_plastic.hpp); half their
// difference is the error [Sloan et al. 2001]. What is left of a distance to the circle goes to alpha.
#pragma once

#include "solver/pm4sand/pm4sand_plastic.hpp"

namespace quicksand::pm4sand {

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
    const Distance w = from_centre(from);
    const double d_x = change.s_x - change.p * from.alpha_x, d_y = change.s_y - change.p * from.alpha_y;
    const double half = 0.5 * m.yield_radius, rho = half * from.p, d_rho = half * change.p;
    const double A = d_x * d_x + d_y * d_y - d_rho * d_rho, B = w.x * d_x + w.y * d_y - rho * d_rho;
    const double C = smaller(0.0, w.x * w.x + w.y * w.y - rho * rho);
    const double root = std::sqrt(larger(0.0, B * B - A * C));
    const bool outward = B > 0.0;
    const double way = select(outward, -C, root - B) / select(outward, B + root, larger(A, 1e-300));
    return select(A + 2.0 * B + C > 0.0, smaller(1.0, way), 1.0);
}

/// Whether a component of alpha has fallen where it turns: since a positive beginning, as published, or below
/// a beginning at zero, which would belong to neither side otherwise and tell a motion from its mirror.
inline bool ends_a_fall(double before, double alpha)
{
    return (before > 0.0) | ((before == 0.0) & (alpha < 0.0));
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
    const bool fell_x = ends_a_fall(before_x, at.alpha_x), fell_y = ends_a_fall(before_y, at.alpha_y);
    set(memory.least_x, select(fell_x, smaller(memory.least_x, at.alpha_x), memory.least_x));
    set(memory.least_y, select(fell_y, smaller(memory.least_y, at.alpha_y), memory.least_y));
    set(memory.most_x, select(fell_x, memory.most_x, larger(memory.most_x, at.alpha_x)));
    set(memory.most_y, select(fell_y, memory.most_y, larger(memory.most_y, at.alpha_y)));
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
    const Point second = plastic_change(m, memory, contact.at, sum(contact.at, 1.0, first), rest);
    Point flown = sum(sum(contact.at, 0.5, first), 0.5, second);
    const double d_p = second.p - first.p, d_x = second.s_x - first.s_x, d_y = second.s_y - first.s_y;
    limit_to_floor(m, memory, flown);
    limit_to_compression(flown);
    limit_fabric(memory, flown);
    return_to_surface(m, flown);
    const bool flows = contact.elastic < 1.0;
    const double error =
        contact.error + select(flows, 0.5 * std::sqrt(d_p * d_p + d_x * d_x + d_y * d_y), 0.0);
    const double resolved = larger(m.resolved_floors, 1.0) * memory.least_stress;
    return {select(flows, flown, contact.at), error / larger(flown.p, resolved)};
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
