#include "solver/pm4sand/pm4sand.hpp"

#include "solver/pm4sand/pm4sand_control.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

using namespace pm4sand;

/// A_d0: so that the dilatancy of the bounding surface is Bolton's (1986) [BZ17]; 1.24 where loose of
/// critical, 1.5 where M^b has no friction angle [CA19].
double dilatancy_factor_at(const Pm4Sand& law, const Surfaces& on)
{
    if (on.xi >= 0.0) return 1.24;
    if (on.Mb > 2.0) return 1.5;
    return 2.5 * (std::asin(0.5 * on.Mb) - std::asin(0.5 * law.critical_ratio)) / (on.Mb - on.Md);
}

/// The memory of a point at its consolidation stress p.
Pm4SandState fresh_memory(const Pm4Sand& law, double p)
{
    Pm4SandState state;
    state.least_stress = std::max(p, atmospheric_pressure) / 200.0; // p_min [CA19]
    const double effective = std::max(p, state.least_stress);
    state.void_ratio = initial_void_ratio(law);
    const Surfaces on = surfaces_at(law, effective, 0.0, state.void_ratio);
    const double limit = std::min(20.0, 0.7 * std::exp(-6.1 * on.xi));
    state.fabric_limit = std::isnan(law.fabric_limit) ? limit : law.fabric_limit;
    state.dilatancy_factor =
        std::isnan(law.dilatancy_factor) ? dilatancy_factor_at(law, on) : law.dilatancy_factor;
    state.fabric_peak = 1e-5 * state.fabric_limit;
    state.peak_stress = 0.01 * effective;
    state.peak_product = -1.0;
    return state;
}

} // namespace

double initial_void_ratio(const Pm4Sand& law)
{
    return law.largest_void_ratio - (law.largest_void_ratio - law.smallest_void_ratio) * law.relative_density;
}

double largest_ratio(const Pm4Sand& law, double mean_stress, double void_ratio)
{
    const double least = atmospheric_pressure / 200.0;
    const Surfaces on = surfaces_at(law, std::max(mean_stress, least), 0.0, void_ratio);
    return std::max(on.Mb, on.Md);
}

bool begin_shaking(const Pm4Sand& law, Pm4SandState& state)
{
    const Point given = point_of(state);
    Pm4SandState fresh = fresh_memory(law, given.p);
    Point at = given;
    at.p = std::max(given.p, floor_factor * fresh.least_stress);
    at.sigma_z = std::max(given.sigma_z, floor_factor * fresh.least_stress);
    at.void_ratio = fresh.void_ratio;
    const double most = largest_ratio(law, at.p, fresh.void_ratio), q = 2.0 * std::hypot(at.s_x, at.s_y);
    const bool outside = q > most * at.p;
    const double scale = outside ? most * at.p / q : 1.0,
                 inside = outside ? (most - law.yield_radius) / most : 1.0;
    at.s_x *= scale, at.s_y *= scale;
    at.alpha_x = inside * at.s_x / at.p, at.alpha_y = inside * at.s_y / at.p;
    at.fabric_x = at.fabric_y = at.fabric_path = 0.0;
    fresh.turn_x = fresh.least_x = fresh.most_x = at.alpha_x;
    fresh.turn_y = fresh.least_y = fresh.most_y = at.alpha_y;
    state = fresh;
    set_point(at, state);
    return outside || at.p != given.p;
}

void update(const Pm4Sand& law, const Pm4SandStrain& strain, Pm4SandState& state)
{
    advance_in_substeps(law, {strain.x - strain.y, strain.shear, strain.x + strain.y}, state);
}

double shear_modulus(const Pm4Sand& law, const Pm4SandState& state)
{
    return elastic_modulus(law, state, point_of(state));
}

} // namespace quicksand
