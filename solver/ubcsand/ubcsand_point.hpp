// The numbers of UBCSAND: the law made ready, the stress and memory of a point, and a strain increment. What
// is done with them: ubcsand.hpp.
#pragma once

#include "solver/reconsolidation/shaking_history.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"

namespace quicksand {

/// Elastic moduli with any exponents or with square roots, and G that stays or softens with small strains.
enum class ElasticForm { powers, square_roots, softening_powers, softening_square_roots };

/// The law made ready: parameters as the kernel uses them. Make it with `make_ubcsand` only.
struct UbcSand {
    double G_atm, B_atm, Gp_atm;     // elastic shear, elastic bulk and plastic shear modulus at s = P_a [Pa]
    double ne, me, np;               // their exponents [-]
    double sin_cv, eta_f;            // sin phi_cv, sin phi_f [-]
    double R;                        // R_f / eta_f [-]
    double a;                        // c cot phi_f, shift of the mean stress [Pa]
    double h1, h2, s0, s1;           // factors of the plastic modulus [-]
    double tolerance_squared;        // reversal tolerance, squared [-]
    double ripple_squared;           // strain of a ripple, squared [-]
    double a_dil_log2;               // softening after dilation, as a power of 2 [-]
    double fac_post;                 // least factor after dilation [-]
    double m_v, m_h, static_shear;   // of the factor that the stress at the start gives [-]
    double least_start_ratio;        // of the stress at the start [-]
    double dilation;                 // factor of D above sin phi_cv [-]
    double per_dilation;             // 1 / shear strain in dilation that halves fac_post [-]
    double per_small_strain;         // 1/(2 gamma_r) [-]
    double least_fraction;           // of G at small strains [-]
    double reconsolidation;          // volumetric strain per largest shear strain [-]
    double liquefied_conductivity;   // k at ru = 1 over k before [-]
    double most_z, least_z;          // bounds of sigma_z + a over the least and the largest stress + a [-]
    double s_min;                    // stress floor [Pa]
    double static_poisson;           // nu while settling under gravity [-]
    double per_ratio_step;           // 1 / largest elastic change of the stress ratio in a substep [-]
    double per_stress_step;          // 1 / largest relative elastic change of s in a substep [-]
    double largest_specific_volume;  // of the loosest sand, per mass of grains [m3/kg]
    double smallest_specific_volume; // of the densest [m3/kg]
    double resolved;                 // mean stress below which changes and errors count as there [Pa]
    double substep_tolerance;        // error of the stress in a substep of second order, relative [-]
    Integration integration;         // of the substeps
    ElasticForm elastic;             // which of the kernels
    SandMemory remembers;

    bool operator==(const UbcSand&) const = default;
};

/// Stress and memory of a point. A new point has the memory `begin_shaking` gives.
struct UbcSandState {
    double sigma_x = 0.0;     // effective stress, compression positive [Pa]
    double sigma_y = 0.0;     // [Pa]
    double sigma_z = 0.0;     // [Pa]
    double tau_xy = 0.0;      // [Pa]
    double eta_max = 0.0;     // largest stress ratio so far [-]
    double branch = 2.0;      // 0 just reversed, 0.5 strain too, 1 far from there, 1.5 in a ripple, 2 loading
    double peak_x = 0.0;      // r where the stress last turned: (sigma_x - sigma_y)/2 over s [-]
    double peak_y = 0.0;      //                                 tau_xy over s [-]
    double origin_x = 0.0;    // the same for the last turn that was not a ripple's [-]
    double origin_y = 0.0;    // [-]
    double leg_x = 0.0;       // strain from where it last reversed to its farthest point, eps_x - eps_y [-]
    double leg_y = 0.0;       //                                                           gamma_xy [-]
    double back_x = 0.0;      // and back from there, eps_x - eps_y [-]
    double back_y = 0.0;      //                      gamma_xy [-]
    double last_leg = 0.0;    // length of the leg before, squared [-]
    double waiting = 0.0;     // 1 a reversal of the strain for loading, -1 loading for a reversal, 0 none
    double half_cycles = 0.0; // n, reversals that were followed by loading [-]
    double dilation = 0.0;    // g_dil, plastic shear strain in dilation [-]
    double active_dilation = 0.0; // its value at the last counted half cycle, which softens the branch [-]
    double dilated_x = 0.0;       // r where the last half cycle turned in which sand with a dilation_strain
    double dilated_y = 0.0;       // dilated; 0: none has [-]
    // bounds of D, given and not remembered: -1, or 0 where the sand is at its loosest, and 1, or 0 where it
    // is at its densest [-]
    double least_contraction = -1.0, most_contraction = 1.0;
    double start_factor = 1.0; // of F, by the stress at the start of shaking; given likewise [-]
    double static_x = 0.0;     // of r where shaking began, the shear stress on horizontal planes over their
    double static_y = 0.0;     // stress; turns with the sand, given likewise [-]
};

/// A strain increment, compression positive, and the rotation that comes with it.
struct UbcSandIncrement {
    double strain_x = 0.0, strain_y = 0.0; // [-]
    double shear = 0.0;                    // d gamma_xy, of the sign of tau_xy [-]
    double spin = 0.0;                     // (L_yx - L_xy) dt / 2, counterclockwise [rad]
};

} // namespace quicksand
