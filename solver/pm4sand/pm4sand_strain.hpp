// A strain increment of PM4Sand, and sums and choices of points and states.
#pragma once

#include "solver/pm4sand/pm4sand_surfaces.hpp"

namespace quicksand::pm4sand {

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

/// combine(a, b) number by number.
template <class Combine>
inline Point combined(const Point& a, const Point& b, Combine&& combine)
{
    return {combine(a.p, b.p),
            combine(a.s_x, b.s_x),
            combine(a.s_y, b.s_y),
            combine(a.sigma_z, b.sigma_z),
            combine(a.alpha_x, b.alpha_x),
            combine(a.alpha_y, b.alpha_y),
            combine(a.fabric_x, b.fabric_x),
            combine(a.fabric_y, b.fabric_y),
            combine(a.fabric_path, b.fabric_path),
            combine(a.void_ratio, b.void_ratio)};
}

/// a + w d for what changes.
inline Point sum(const Point& a, double w, const Point& d)
{
    return combined(a, d, [w](double number, double change) { return number + w * change; });
}

inline Point select(bool condition, const Point& yes, const Point& no)
{
    return combined(yes, no, [condition](double y, double n) { return select(condition, y, n); });
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

} // namespace quicksand::pm4sand
