// Plastic modulus, dilatancy and fabric of PM4Sand at a point that flows in a direction u.
//
// With a:n = sqrt(2) a.u of vectors, b = alpha^b - alpha, alpha^b = (M^b - m)/2 u, alpha^d = (M^d - m)/2 u,
// alpha^dr = (M^d/C_rot1 - m)/2 u:
//   K_p = G h0 sqrt(b:n) / (exp((alpha - alpha_in):n) - 1 + C_g1)
//         C_Kalpha / (1 + 2 z_peak/z_max <b:n> sqrt(1 - C_zpk2)) C_rev
//   contraction, (alpha^dr - alpha):n > 0
//     D = min(A_dc ((alpha - alpha_in):n + C_in)^2, 1.5 A_d0)
//         (alpha^d - alpha):n / ((alpha^d - alpha):n + 0.16)
//   dilation
//     D = A_d (alpha^d - alpha):n, or that of the rotated surface; bounded near p_min
//   dz = -c_z/(1 + <z_cum/(2 z_max) - 1>) (z_max n + z) dL where the sand dilates beyond alpha^d
// with the factors below. dL is the plastic multiplier: plastic strain is (n + D/3 I) dL.
#pragma once

#include "solver/pm4sand/pm4sand_surfaces.hpp"

namespace quicksand::pm4sand {

inline constexpr double root_2 = 1.41421356237309515;

/// Rates by the plastic shear strain lambda = sqrt(2) L.
struct Flow {
    double G, K;        // [Pa]
    double half_Kp;     // K_p/2, of softening at most what leaves half of the resistance [Pa]
    double resistance;  // G + K_p/2 - K D r.u, at least 0.05 G [Pa]
    double D;           // d eps_v^p / d lambda, contraction positive [-]
    double pull, bound; // P, b in d alpha / d lambda = P (b u - alpha)/p [Pa, -]
    double fabric_rate; // of d z / d lambda = rate (z_max u/sqrt(2) + z) [-]
};

/// What the flow depends on besides the stress: projections on the direction.
struct Projections {
    double bound, dilatancy, rotated;     // (alpha^b, alpha^d, alpha^dr - alpha):n [-]
    double from_start, from_turn, before; // (alpha - alpha_in, - true alpha_in, - the one before):n [-]
    double fabric;                        // z:n [-]
    double novelty;                       // C_zin1, how far z is from that of the last reversal [-]
};

inline Projections projections_of(const Pm4Sand& m, const Pm4SandState& memory, const Point& at,
                                  const Surfaces& on, double u_x, double u_y)
{
    const auto along = [&](double x, double y) { return root_2 * (x * u_x + y * u_y); };
    const double alpha = along(at.alpha_x, at.alpha_y), limit = memory.fabric_limit;
    Projections to;
    to.fabric = along(at.fabric_x, at.fabric_y);
    const double change = along(memory.origin_x, memory.origin_y) - to.fabric;
    to.novelty = 1.0 - exponential(-smaller(2.0 * std::abs(change) / limit, 600.0));
    const double turned = 1.0 + root_2 * positive(-to.fabric) / limit * (1.0 - to.novelty); // C_rot1
    to.bound = (on.Mb - m.yield_radius) / root_2 - alpha;
    to.dilatancy = (on.Md - m.yield_radius) / root_2 - alpha;
    to.rotated = (on.Md / turned - m.yield_radius) / root_2 - alpha;
    to.from_start = alpha - along(memory.start_x, memory.start_y);
    to.from_turn = positive(alpha - along(memory.turn_x, memory.turn_y));
    to.before = alpha - along(memory.previous_x, memory.previous_y);
    return to;
}

/// K_p without the sign of b:n in contraction [Pa].
inline double plastic_modulus(const Pm4Sand& m, const Pm4SandState& memory, const Point& at,
                              const Projections& to, double p, double G)
{
    constexpr double smooth = 1e-6; // of |b:n|, where the root has no slope
    const double limit = memory.fabric_limit, peak = memory.fabric_peak, path = at.fabric_path;
    const double worn = smaller(1.0 - 1e-10, peak / (path + 0.01 * limit)); // C_zpk2
    const double known = peak / (path + 0.2 * limit);                       // C_zpk1
    const double released = positive(memory.peak_stress - p);
    const double stress = released / (released + memory.least_stress); // C_pzp2
    const double far = 2.5 * to.from_turn;
    const double shear_bias = 1.0 + m.static_shear_factor / (1.0 + far * far) * stress * known; // C_Kalpha
    const double start = 0.005 * m.modulus_ratio;                                               // C_g1
    const double from_start = positive(to.from_start);
    const double reversed =
        select(to.before <= 0.0, (from_start + start) / (to.from_turn + start), 1.0); // C_rev
    const double softened = 1.0 + 2.0 * peak / limit * positive(to.bound) * std::sqrt(1.0 - worn);
    return G * m.modulus_ratio * to.bound * shear_bias * reversed /
           (std::sqrt(std::abs(to.bound) + smooth) * (exponential(from_start) - 1.0 + start) * softened);
}

/// D of contraction.
inline double contraction(const Pm4Sand& m, const Pm4SandState& memory, const Point& at, const Surfaces& on,
                          const Projections& to, double p)
{
    const double limit = memory.fabric_limit, peak = memory.fabric_peak, path = at.fabric_path;
    const double state = positive(0.5 - on.xi);
    const double rate = m.contraction_rate * exponential(-0.7 + 7.0 * state * state); // h_p
    const double fresh = 1.0 - smaller(1.0 - 1e-10, peak / (path + 0.01 * limit));    // C_rot2
    const double fabric = larger((1.0 - fresh * root_2 * peak / limit) * (limit / (limit + fresh * path)),
                                 1.0 / (1.0 + 0.5 * limit)); // C_dz
    const double along = positive(to.fabric), start = to.from_start + root_2 * along / limit;
    const double factor = memory.dilatancy_factor * (1.0 + along) / (rate * fabric); // A_dc
    const double strength = smaller(factor * start * start, 1.5 * memory.dilatancy_factor);
    const double floors = p / memory.least_stress;
    const double low = smaller(1.0, positive((floors - 2.0) / 16.0)); // C_pmin2
    return low * strength * to.dilatancy / (to.dilatancy + 0.16);
}

/// D of dilation.
inline double dilation(const Pm4Sand& m, const Pm4SandState& memory, const Point& at, const Surfaces& on,
                       const Projections& to, double p)
{
    const double limit = memory.fabric_limit, peak = memory.fabric_peak, path = at.fabric_path;
    const double A = memory.dilatancy_factor, against = positive(-to.fabric), floor = memory.least_stress;
    const double ratio = 2.5 * p / memory.peak_stress, squared = ratio * ratio;
    const double of_peak = 1.0 / (1.0 + squared * squared * ratio); // C_pzp
    const double floors = 10.0 * floor / p;
    const double of_floor = 1.0 / (1.0 + floors * floors); // C_pmin
    const double worn = to.novelty * (path - peak) / (3.0 * limit);
    const double loosened = (1.0 + worn) / (1.0 + 3.0 * worn); // C_zin2
    const double rest = 1.0 - against / (root_2 * peak);
    const double history = path * path / limit * (rest * rest * rest) *
                           (m.strain_accumulation * m.strain_accumulation) * of_peak * of_floor * to.novelty;
    const double rate = A * loosened / (history + 1.0); // A_d
    const double plain = rate * to.dilatancy;
    const double rotated = rate * against / (root_2 * limit) * to.rotated / m.rotated_dilatancy;
    const double below = positive(on.Mb - on.eta);
    const double mixed = plain + (rotated - plain) * below / (below + 0.01);
    const double D = select(plain > rotated, mixed, plain);
    const double least = -3.5 * A * positive(on.Mb - on.Md) * (2.0 * floor - p) / floor;
    return select(p <= 2.0 * floor, smaller(D, least), D);
}

inline Flow flow_at(const Pm4Sand& m, const Pm4SandState& memory, const Point& at, double u_x, double u_y)
{
    const double p = larger(at.p, memory.least_stress), limit = memory.fabric_limit;
    const double q = 2.0 * std::sqrt(at.s_x * at.s_x + at.s_y * at.s_y);
    const Surfaces on = surfaces_at(m, p, q, at.void_ratio);
    const Projections to = projections_of(m, memory, at, on, u_x, u_y);
    const bool contracts = to.rotated > 0.0;
    Flow flow;
    flow.G = shear_modulus_at(m, on, p, at.p, at.fabric_path / limit);
    flow.K = m.bulk_over_shear * flow.G;
    const double D =
        select(contracts, contraction(m, memory, at, on, to, p), dilation(m, memory, at, on, to, p));
    flow.D = D / root_2;
    const double Kp = plastic_modulus(m, memory, at, to, p, flow.G);
    const double resists = flow.G - flow.K * flow.D * ((at.s_x * u_x + at.s_y * u_y) / at.p);
    flow.half_Kp = larger(0.5 * select(contracts, positive(Kp), Kp), -0.5 * positive(resists));
    flow.resistance = larger(resists + flow.half_Kp, 0.05 * flow.G);
    flow.pull =
        flow.half_Kp * root_2 / select(to.bound < 0.0, smaller(to.bound, -1e-12), larger(to.bound, 1e-12));
    flow.bound = 0.5 * (on.Mb - m.yield_radius);
    const bool builds = (to.dilatancy < 0.0) & (D < 0.0);
    const double slowed = 1.0 + positive(0.5 * at.fabric_path / limit - 1.0);
    flow.fabric_rate = select(builds, -m.fabric_rate / (slowed * root_2), 0.0);
    return flow;
}

} // namespace quicksand::pm4sand
