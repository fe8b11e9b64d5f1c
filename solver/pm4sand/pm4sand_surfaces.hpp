// Elastic moduli, bounding and dilatancy surface of PM4Sand at a mean stress p and a void ratio.
//
//   xi = R/(Q - ln(100 p/Pa)) - Dr                relative state, negative where dense of critical
//   M^b = M exp(-n_b xi), M^d = M exp(n_d xi)      dense of critical; n_b/4 and 4 n_d where loose of it
//   G = G0 Pa sqrt(p/Pa) C_SR (1 + c)/(1 + C_GD c), C_SR = 1 - min(1, (eta/M^b)^4)/2, c = z_cum/z_max
//   K/G from Poisson's ratio
// eta = q/p with q = sigma_1 - sigma_3. Below p_min all of it is taken at p_min.
#pragma once

#include "solver/pm4sand/pm4sand_parameters.hpp"
#include "solver/pm4sand/pm4sand_point.hpp"
#include "solver/ubcsand/ubcsand_choices.hpp"
#include "solver/ubcsand/ubcsand_power.hpp"

#include <cmath>

namespace quicksand::pm4sand {

using ubcsand::exponential_2;
using ubcsand::larger;
using ubcsand::logarithm_2;
using ubcsand::select;
using ubcsand::smaller;

inline double exponential(double x)
{
    return exponential_2(1.442695040888963407 * x);
}

/// <x>
inline double positive(double x)
{
    return larger(x, 0.0);
}

/// What a substep changes, without what only reversals change.
struct Point {
    double p, s_x, s_y, sigma_z;                              // mean stress and deviator [Pa]
    double alpha_x, alpha_y, fabric_x, fabric_y, fabric_path; // as in the state [-]
    double void_ratio;                                        // [-]
};

struct Surfaces {
    double xi;     // relative state [-]
    double Mb, Md; // q/p on the bounding and dilatancy surface [-]
    double eta;    // q/p [-]
};

inline Surfaces surfaces_at(const Pm4Sand& m, double p, double q, double void_ratio)
{
    constexpr double ln_2 = 0.693147180559945309;
    const double depth = m.bolton_q - ln_2 * logarithm_2(p * (100.0 / atmospheric_pressure));
    const double density =
        (m.largest_void_ratio - void_ratio) / (m.largest_void_ratio - m.smallest_void_ratio);
    Surfaces at;
    at.xi = m.bolton_r / larger(depth, 0.1) - density;
    const bool dense = at.xi <= 0.0;
    at.Mb = m.critical_ratio * exponential(-select(dense, 1.0, 0.25) * m.bounding_exponent * at.xi);
    at.Md = m.critical_ratio * exponential(select(dense, 1.0, 4.0) * m.dilatancy_exponent * at.xi);
    at.eta = q / p;
    return at;
}

/// F_sed: the softening of liquefied sand that settles after shaking [-].
inline double sedimentation(const Pm4Sand& m, const Surfaces& at, double p, double path_over_limit)
{
    constexpr double least = 1e-6; // [Pa]
    const double below = positive(1.0 - at.eta / at.Md);
    const double stress =
        m.sedimentation_stress * path_over_limit / (1.0 + path_over_limit) * std::sqrt(std::sqrt(below));
    const double grown =
        m.sedimentation_floor + (1.0 - m.sedimentation_floor) * p / (20.0 * (stress + least));
    return smaller(1.0, grown);
}

/// G [Pa]; the present p is for the softening alone.
inline double shear_modulus_at(const Pm4Sand& m, const Surfaces& at, double p, double present_p,
                               double path_over_limit)
{
    const double ratio = at.eta / at.Mb, squared = ratio * ratio;
    const double stress_factor = 1.0 - 0.5 * smaller(1.0, squared * squared);
    const double fabric_factor = (1.0 + path_over_limit) / (1.0 + m.modulus_degradation * path_over_limit);
    const double settling =
        1.0 - m.reconsolidation * (1.0 - sedimentation(m, at, present_p, path_over_limit));
    return m.shear_coefficient * atmospheric_pressure * std::sqrt(p * (1.0 / atmospheric_pressure)) *
           stress_factor * fabric_factor * settling;
}

} // namespace quicksand::pm4sand
