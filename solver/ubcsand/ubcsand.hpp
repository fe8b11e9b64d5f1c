// UBCSAND for one point and for arrays of points: effective stress of sand that contracts and dilates under
// cyclic shear, so that its pore water gains pressure and the sand liquefies.
//
// What       Radial yield loci in stress ratio that the stress drags along, a hyperbola of hardening, the
//            flow rule sin psi = eta - sin phi_cv, a Mohr-Coulomb limit, elastic unloading, stiff reloading,
//            softening after dilation. Parameters and reference: ubcsand_parameters.hpp; equations:
//            ubcsand_kernel.hpp.
// Units/signs  UbcSandState and UbcSandIncrement are compression positive, as the model is published; the
//            arrays of points are tension positive, as everywhere else. Shear strain is engineering shear.
// Limits     Start from a stress inside the failure limit (K_0 of 0.5; elastic gravity loading with these
//            moduli gives 0.016). Turning of the principal stresses at constant ratio causes no plastic
//            strain. Ripples are no half cycles where the parameters have a strain of ripples, as in runs,
//            and the locus stays at the last true reversal; those of unloading contract the sand a little.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"
#include "solver/ubcsand/ubcsand_point.hpp"

#include <cstddef>

namespace quicksand {

struct Gradients;

UbcSand make_ubcsand(const UbcSandParameters& parameters);

/// Start of the dynamic stage: the present stress is the last peak, and nothing has dilated yet. The axes of
/// the stress are horizontal and vertical: K_0 and the static shear stress are read from it.
void begin_shaking(const UbcSand& law, UbcSandState& state);

/// Advance a point by a strain increment.
///
///  1  turn the stress and what is remembered of ratios and strains by the spin
///  2  divide the increment into substeps; for each of them
///  3  elastic moduli at the present mean stress, not below the floor
///  4  elastic trial
///  5  ratio of the yield locus: dragged along, or at the last reversal for a tiny excursion from it
///  6  the trial's mean stress is not below the floor
///  7  inside the locus: elastic; the first such substep after loading is a reversal, which is remembered
///  8  outside: loading after a reversal counts a half cycle, the plastic modulus follows from memory, the
///     stress returns to the hardened locus, to the failure line, or flows at the stress floor
///  9  out-of-plane stress; strain in dilation
/// 10  stress in the direction of the trial, largest ratio
///
/// In first order, the published form, substeps have a fixed elastic change of stress. In second order a step
/// is tried whole, and divided where the law changes or its error is too large: ubcsand_attempt.hpp.
///
/// With a strain of ripples a half cycle needs, besides loading after a reversal, that the strain itself has
/// turned and gone that far back, or a quarter of the longer of its last two legs when that is less. Until
/// then unloading is an excursion, which reloads elastically.
void update(const UbcSand& law, const UbcSandIncrement& increment, UbcSandState& state);

/// Step 1 alone. Tangent of half the angle is half the spin (Hughes and Winget 1980).
void turn(double spin, UbcSandState& state);

/// G [Pa] of unloading at the present stress.
double shear_modulus(const UbcSand& law, const UbcSandState& state);

/// E1 = K' + G = B + 4G/3 [Pa] with d s = K' d eps_v, the stiffest response at the present stress: unloading
/// in one dimension.
double constrained_modulus(const UbcSand& law, const UbcSandState& state);

/// Points as structure of arrays, tension positive. None of the arrays may overlap.
struct UbcSandArrays {
    const double *L_xx, *L_xy, *L_yx, *L_yy;               // velocity gradient [1/s]
    double *stress_xx, *stress_yy, *stress_zz, *stress_xy; // effective stress [Pa]
    double *eta_max, *branch, *peak_x, *peak_y;            // memory as in UbcSandState and of its signs
    double *origin_x, *origin_y, *leg_x, *leg_y, *back_x, *back_y, *last_leg, *waiting;
    double *half_cycles, *dilation, *active_dilation;
    const double *volume, *mass_solid; // [m3/m, kg/m], which tell where the sand is at its loosest or densest
    const double* start_factor = nullptr;                  // of the plastic modulus [-]; none: 1
    double *dilated_x = nullptr, *dilated_y = nullptr;     // none: sand without a dilation_strain
    const double *static_x = nullptr, *static_y = nullptr; // likewise

    /// All but what may be missing.
    UbcSandState state(std::size_t p) const
    {
        return {-stress_xx[p], -stress_yy[p],  -stress_zz[p], -stress_xy[p],     eta_max[p],
                branch[p],     peak_x[p],      peak_y[p],     origin_x[p],       origin_y[p],
                leg_x[p],      leg_y[p],       back_x[p],     back_y[p],         last_leg[p],
                waiting[p],    half_cycles[p], dilation[p],   active_dilation[p]};
    }

    void set(std::size_t p, const UbcSandState& state) const
    {
        stress_xx[p] = -state.sigma_x, stress_yy[p] = -state.sigma_y, stress_zz[p] = -state.sigma_z;
        stress_xy[p] = -state.tau_xy;
        eta_max[p] = state.eta_max, branch[p] = state.branch;
        peak_x[p] = state.peak_x, peak_y[p] = state.peak_y;
        origin_x[p] = state.origin_x, origin_y[p] = state.origin_y;
        leg_x[p] = state.leg_x, leg_y[p] = state.leg_y;
        back_x[p] = state.back_x, back_y[p] = state.back_y;
        last_leg[p] = state.last_leg, waiting[p] = state.waiting;
        half_cycles[p] = state.half_cycles;
        dilation[p] = state.dilation, active_dilation[p] = state.active_dilation;
    }

    /// What may be missing.
    void add_to(std::size_t p, UbcSandState& state) const
    {
        if (start_factor != nullptr) state.start_factor = start_factor[p];
        if (dilated_x == nullptr) return;
        state.dilated_x = dilated_x[p], state.dilated_y = dilated_y[p];
        state.static_x = static_x[p], state.static_y = static_y[p];
    }

    void set_dilated(std::size_t p, const UbcSandState& state) const
    {
        if (dilated_x != nullptr) dilated_x[p] = state.dilated_x, dilated_y[p] = state.dilated_y;
    }
};

/// Advance the points [first, last) by dt; the same bits as `update` one by one. Spin is left to the caller,
/// who turns the points before, or not at all in small strain.
void update(const UbcSand& law, double dt, std::size_t first, std::size_t last, const UbcSandArrays& points);

/// Constrained moduli of the points [first, last) by their stresses [Pa] and volumes [m3/m].
ParticleModuli particle_moduli(const UbcSand& law, std::size_t first, std::size_t last,
                               const double* stress_xx, const double* stress_yy, const double* volume);

/// The same at the largest stress that the velocity gradient L can lead to over dt, by contraction and by
/// dilation at the failure limit, which the water holds back: moduli that grow with the root of the mean
/// stress s grow by (K'/s) / 2 times the strain, for d s = K' d eps_v.
ParticleModuli expected_moduli(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                               const Gradients& L, const double* stress_xx, const double* stress_yy,
                               const double* volume);

} // namespace quicksand
