// The change of PM4Sand's stress and memory by a plastic strain.
//
// Flow: dp = K1 d eps_v - K D lambda and ds = G (d eps_x - d eps_y, d gamma_xy) - G lambda u with
// K1 = K + G/3 and lambda = (G g.u - r.u K1 d eps_v) / (G + K_p/2 - K D r.u). The report has K in the place
// of K1, which is the rate of the mean stress in the plane: with K1 the stress stays on the circle.
//
// Direction: u turns to the strain within a strain of m p/(2 G), 1e-6 in liquefied sand, because the circle
// is small. Its vector w = s - p alpha follows dw = dX - lambda (G + P b) u, where X is what does not depend
// on u. The rates at the ends of a longer substep would be unstable. The linear relaxation has, over z
// = lambda (G + P b)/(m p/2) of its lengths, the mean u along w + theta X with theta = 1/(1 - exp(-z)) - 1/z,
// here (3 + z)/(6 + z): the middle of a short substep and the end of a long one.
//
// Floor: the mean stress is at least p_min/5; what would go below opens the grains without stress.
#pragma once

#include "solver/pm4sand/pm4sand_flow.hpp"
#include "solver/pm4sand/pm4sand_strain.hpp"

namespace quicksand::pm4sand {

inline constexpr double floor_factor = 0.2; // of p_min, the least mean stress [-]

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

/// A unit vector along the distance to the centre of the yield surface; (0, 1) at the centre.
struct Direction {
    double x, y;
};
inline Direction direction_along(double x, double y)
{
    const double size = std::sqrt(x * x + y * y), per_size = 1.0 / larger(size, 1e-200);
    return {x * per_size, select(size > 1e-200, y * per_size, 1.0)};
}

/// w = s - p alpha, the distance to the centre of the yield surface [Pa].
struct Distance {
    double x, y;
};
inline Distance from_centre(const Point& at)
{
    return {at.s_x - at.p * at.alpha_x, at.s_y - at.p * at.alpha_y};
}

inline Direction direction_of(const Point& at)
{
    const Distance w = from_centre(at);
    return direction_along(w.x, w.y);
}

/// The mean direction of flow of a strain from `start`, whose elastic change and lambda are those at `at`.
inline Direction mean_direction(const Pm4Sand& m, const Point& start, const Point& at, const Flow& flow,
                                const Point& elastic, double lambda)
{
    const double radius = 0.5 * m.yield_radius * at.p;
    const double way = lambda * (flow.G + flow.pull * flow.bound) / radius;
    const double share = (3.0 + way) / (6.0 + way);
    const double drawn = lambda * (flow.pull + flow.K * flow.D) - elastic.p;
    const Distance w = from_centre(start);
    return direction_along(w.x + share * (elastic.s_x + drawn * at.alpha_x),
                           w.y + share * (elastic.s_y + drawn * at.alpha_y));
}

/// The plastic shear strain that brings a stress which would go from `start` by an elastic change back to the
/// circle, in a direction u, at the rates of `at` [-].
inline double multiplier(const Pm4Sand& m, const Point& start, const Point& at, const Flow& flow,
                         const Point& elastic, const Direction& u)
{
    const double ratio = (at.s_x * u.x + at.s_y * u.y) / at.p;
    const double driven = elastic.s_x * u.x + elastic.s_y * u.y - ratio * elastic.p;
    const Distance w = from_centre(start);
    const double inside = 0.5 * m.yield_radius * start.p - (w.x * u.x + w.y * u.y);
    return positive(driven - inside) / flow.resistance;
}

/// The change of a plastic strain from `start` at the rates of a point of it.
inline Point plastic_change(const Pm4Sand& m, const Pm4SandState& memory, const Point& start,
                            const Point& given, const Strain& strain)
{
    Point at = given;
    limit_to_floor(m, memory, at);
    const Direction now = direction_of(at);
    const Flow flow = flow_at(m, memory, at, now.x, now.y);
    Point change = elastic_change(m, at, flow.G, strain);
    const double expected = multiplier(m, start, at, flow, change, now);
    const Direction u = mean_direction(m, start, at, flow, change, expected);
    const double lambda = multiplier(m, start, at, flow, change, u);
    change.p -= flow.K * flow.D * lambda;
    change.sigma_z -= flow.K * flow.D * lambda;
    change.s_x -= flow.G * lambda * u.x;
    change.s_y -= flow.G * lambda * u.y;
    const double pull = flow.pull / at.p * lambda;
    change.alpha_x = pull * (flow.bound * u.x - at.alpha_x);
    change.alpha_y = pull * (flow.bound * u.y - at.alpha_y);
    const double built = flow.fabric_rate * lambda, most = memory.fabric_limit / root_2;
    change.fabric_x = built * (most * u.x + at.fabric_x);
    change.fabric_y = built * (most * u.y + at.fabric_y);
    change.fabric_path = std::sqrt(change.fabric_x * change.fabric_x + change.fabric_y * change.fabric_y);
    return change;
}

} // namespace quicksand::pm4sand
