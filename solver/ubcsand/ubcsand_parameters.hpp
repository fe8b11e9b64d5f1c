// Parameters of UBCSAND and the generic set that the blow count gives.
//
// Sources    [BB11] the generic set of Beaty and Byrne (2011), report 904aR, as the literature repeats it
//            [IB08] Idriss and Boulanger (2008): relative density; triggering curve at 15 cycles
//            [own]  the memory of cycles, a reconstruction: h2 calibrated to [IB08], the others chosen
//            [B86]  Bolton (1986): sand of a relative density of 45 % dilates by some 10 deg more than the
//            friction of constant volume at 25 kPa, not by 1
//            [DL82] Dobry, Ladd, Yokel, Chung and Powell (1982): sand keeps its volume below a shear strain
//            of 1e-4
//            [YWS06] Yoshimine, Nishizaki, Amano and Hosono (2006), after Ishihara and Yoshimine (1992):
//            volumetric strain of reconsolidation, as [IB08] put it for blow counts
//            [Sha12] Shahir, Pak, Taiebat and Jeremic (2012): conductivity of liquefied sand
// Limits     Plane strain. The set is tied to a density: a soil that densifies keeps its parameters.
#pragma once

#include <limits>
#include <optional>

namespace quicksand {

/// How a substep is integrated. The published algorithm is of first order; its reference strengths hold for
/// it and for small steps. Second order allows substeps some twenty times longer, as runs need.
enum class Integration { first_order, second_order };

/// What bounds the stress out of the plane: only the stress floor, or the failure limit as well.
enum class OutOfPlaneStress { free, within_failure };

/// Defaults are the generic set for (N1)60 = 13.9 in round numbers; `ubcsand_from_blow_count` gives all
/// digits of one.
struct UbcSandParameters {
    double relative_density = 0.55; // Dr of the blow count [-] [IB08]

    // elasticity: G = K_G P_a (s/P_a)^ne, B = K_B P_a (s/P_a)^me, s the in-plane mean [BB11]
    double elastic_shear_number = 1043.7; // K_G^e [-], 434 N^(1/3)
    double elastic_bulk_number = 730.6;   // K_B^e [-], 0.7 K_G^e, drained (never the pore water's)
    double elastic_shear_exponent = 0.5;  // ne [-]
    double elastic_bulk_exponent = 0.5;   // me [-]

    // hardening: d eta = (G^p/s) d gamma^p,  G^p = F K_G^p P_a (s/P_a)^np (1 - R_f eta/eta_f)^2 [BB11]
    double plastic_shear_number = 704.9; // K_G^p [-], 0.003 K_G^e N^2 + 100
    double plastic_shear_exponent = 0.4; // np [-]
    double failure_ratio = 0.7412;       // R_f [-], 1.1 N^-0.15, at most 0.99

    // flow and failure: eta = sin(phi_cv) divides contraction from dilation
    double constant_volume_friction_deg = 33.0; // phi_cv [deg] [BB11]
    double peak_friction_deg = 34.39;           // phi_f [deg], phi_cv + N/10 + max(0, (N - 15)/5) [BB11]
    double cohesion = 0.0;                      // c [Pa]

    // memory of cycles: F = h1 on virgin loading, h1 h2 (s0 + s1 n) below the largest ratio [own]
    double virgin_factor = 1.0;       // h1 [-]
    double secondary_factor = 0.6;    // h2 [-], calibrated: 0.6 meets the triggering curve for N = 5 to 20
    double secondary_start = 4.0;     // s0 [-]
    double secondary_growth = 0.5;    // s1 [-] per half cycle
    double reversal_tolerance = 0.02; // smallest change of the stress ratio that counts as a reversal [-]
    double ripple_strain = 0.0;       // shear strain of ripples, which are no half cycles; 0: no ripples [-]
    double dilation_softening = 1000.0; // a_dil [-]; F falls by exp(-a_dil x shear strain in dilation)
    double softened_factor = 0.05;      // least F after dilation [-]

    // strength by the stress at the start of shaking: F times max(1, sigma'_v/P_a)^-m_v ((1 + K_0)/1.5)^m_h
    // (1 + a |tau|/sigma'_v) [own], as practice fits h1 to depth and slope; under less than one atmosphere
    // the exponents of the moduli alone bring K_sigma to its limit of 1.1 [IB08]
    double confining_exponent = 0.0;      // m_v [-]
    double lateral_exponent = 0.0;        // m_h [-]
    double static_shear_stiffening = 0.0; // a [-]
    double least_start_ratio = 0.0;       // of the stress that the start remembers as its largest [-]

    // after liquefaction: above the ratio of constant volume D times a factor, for sand dilates more under
    // little stress than the friction of the generic set says [B86], and the least F over 1 + g_dil/strain,
    // g_dil up to the last half cycle, so that strains grow where the sand flows, on both sides alike, and
    // then only against the sense in which it last dilated [own]
    double dilation_factor = 1.0;                                     // [-]
    double dilation_strain = std::numeric_limits<double>::infinity(); // [-]

    // small strains: G falls by (1 + gamma/(2 gamma_r))^-2 with the shear strain since it turned, which is
    // the hyperbola of Hardin and Drnevich (1972) with the rule of Masing (1926); not below a fraction [own]
    double reference_strain = std::numeric_limits<double>::infinity(); // gamma_r [-]
    double least_modulus_fraction = 1.0;                               // [-]

    // after liquefaction
    double reconsolidation_slope = 0.0;  // volumetric strain per largest shear strain [-] [YWS06]
    double liquefied_conductivity = 1.0; // k at ru = 1 over k before [-] [Sha12]

    OutOfPlaneStress out_of_plane = OutOfPlaneStress::free;

    // the loosest sand: it does not dilate; without contact of its grains it has no stiffness until they
    // touch [own]
    double largest_specific_volume = std::numeric_limits<double>::infinity(); // per mass of grains [m3/kg]
    double smallest_specific_volume = 0.0; // of the densest sand, which does not contract [m3/kg] [own]

    // settling under gravity, see settling_sand.hpp [own]
    double static_poisson_ratio = 1.0 / 3.0; // nu [-]; level ground settles to K_0 = nu/(1 - nu) = 0.5

    // numerics: the elastic changes of a substep [own]
    double largest_ratio_step = 0.004; // of the stress ratio [-]
    double largest_stress_step = 0.02; // of the mean stress, relative [-]
    double resolved_floors = 0.0;      // below this multiple of the floor stresses count as there [-]
    double substep_tolerance = 0.003;  // error of the stress in a substep of second order, relative [-]
    Integration integration = Integration::first_order;
    double stress_floor = 500.0; // s_min, least mean stress [Pa]; dilation can lift a point off it
};

/// What a run sets otherwise. Waves on the grid put ripples on the strain of every point; below a strain of
/// 1e-4 sand keeps its volume [DL82]. Substeps of second order are as long as their error allows; their
/// elastic changes have bounds for absurd strains only.
struct UbcSandRunSettings {
    Integration integration = Integration::second_order;
    double ripple_strain = 1e-4;      // [-]
    double largest_ratio_step = 10.0; // [-]
    double largest_stress_step = 0.5; // [-]
    double resolved_floors = 20.0;    // [-]
    double substep_tolerance = 0.003; // [-]
};

/// The parameters with the settings of a run.
UbcSandParameters with(const UbcSandRunSettings& settings, UbcSandParameters parameters);

/// The generic set for a clean-sand blow count (N1)60 [-]. What the set derives from K_G^e [-] and phi_cv
/// [deg] follows those given.
UbcSandParameters ubcsand_from_blow_count(double n1_60, std::optional<double> elastic_shear_number = {},
                                          std::optional<double> constant_volume_friction_deg = {});

/// The generic set with the factors that bring static shear, confining stress, K_0, strains after
/// liquefaction and small strains to what laboratories measure; triggering at one atmosphere and K_0 = 1/2
/// stays. [own]
UbcSandParameters calibrated(UbcSandParameters generic);

/// The generic set for a relative density [-], by (N1)60 = 46 Dr^2 [IB08].
UbcSandParameters ubcsand_from_relative_density(double relative_density);

inline constexpr double nevada_relative_density = 0.55; // [-]

/// Nevada sand at a relative density of 55 %, (N1)60 = 13.915: the generic set, not a fit to its tests.
UbcSandParameters nevada_sand_55();

/// (N1)60 = 46 Dr^2 [-]
double blow_count(double relative_density);

/// Throw InputError when the parameters make no soil, with the name of the first that does not.
void check(const UbcSandParameters& parameters);

} // namespace quicksand
