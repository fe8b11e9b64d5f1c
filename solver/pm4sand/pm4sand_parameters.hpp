// The parameters of PM4Sand and what they are where the user gives none.
//
// Sources: [BZ17] Boulanger and Ziotopoulou (2017), PM4Sand (Version 3.1), report UCD/CGM-17/01. The report
// was not at hand: its equations and constants are taken as facts from the public implementation of Chen and
// Arduino (University of Washington) [CA19] and from memory. Where the two are known to differ it is said
// beside the number.
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/reconsolidation/shaking_history.hpp"
#include "solver/soil/law_key.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

namespace quicksand {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct Pm4Sand {
    // the three that are calibrated
    double relative_density = not_given;  // Dr, or from the blow count [-]
    double n1_60 = not_given;             // clean-sand blow count (N1)60, or from Dr [-]
    double shear_coefficient = not_given; // G0 of G = G0 Pa sqrt(p/Pa) [-]
    double contraction_rate = not_given;  // hpo, larger contracts less [-]

    // those with values of their own
    double modulus_ratio = not_given;                         // h0, plastic over elastic modulus [-]
    double largest_void_ratio = 0.8;                          // e_max [-]
    double smallest_void_ratio = 0.5;                         // e_min [-]
    double bounding_exponent = 0.5;                           // n_b [-]
    double dilatancy_exponent = 0.1;                          // n_d [-]
    double dilatancy_factor = not_given;                      // A_d0, or by the state at consolidation [-]
    double fabric_limit = not_given;                          // z_max, or by the state at consolidation [-]
    double fabric_rate = 250.0;                               // c_z [-]
    double strain_accumulation = not_given;                   // c_eps [-]
    double constant_volume_friction_deg = 33.0;               // phi_cv [deg]
    double drained_poisson_ratio = 0.3;                       // nu, drained [-]
    double modulus_degradation = 2.0;                         // C_GD [-]
    double rotated_dilatancy = not_given;                     // C_DR [-]
    double static_shear_factor = not_given;                   // C_Kaf [-]
    double bolton_q = 10.0;                                   // Q [-]
    double bolton_r = 1.5;                                    // R [-]
    double yield_radius = 0.01;                               // m [-]
    double sedimentation_floor = not_given;                   // F_sed,min [-]
    double sedimentation_stress = 0.2 * atmospheric_pressure; // p_sed,o [Pa]
    double reconsolidation = 0.0;        // share of the softening while liquefied sand settles [-]
    double reconsolidation_slope = 0.0;  // volumetric strain per largest shear strain [-] [YWS06]
    double liquefied_conductivity = 1.0; // k at ru = 1 over k before [-] [Sha12]

    // of this program
    double static_poisson_ratio = 1.0 / 3.0; // nu while settling under gravity [-]
    double stress_tolerance = 1e-3;          // error of the stress in a substep, relative [-]
    double resolved_floors = 20.0;           // below this multiple of p_min errors count as at it [-]
    SandMemory remembers = SandMemory::of_cycles;

    // derived by complete()
    double critical_ratio = not_given;  // M = 2 sin phi_cv [-]
    double bulk_over_shear = not_given; // K/G [-]
};

/// By their bits: what is not given is equal to what is not given.
inline bool operator==(const Pm4Sand& a, const Pm4Sand& b)
{
    using Bits = std::array<std::uint64_t, sizeof(Pm4Sand) / sizeof(std::uint64_t)>;
    static_assert(sizeof(Bits) == sizeof(Pm4Sand));
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// The parameters with a value for every one that is not given, but those of the state at consolidation.
Pm4Sand complete(Pm4Sand law);

/// Parameters that complete_calibrated() completes: damping at 0.001 to 0.1 % is that of laboratories, which
/// the report's values miss, by the parameters that it leaves to the user: h0 = Dr + 0.11, m = 0.005, and hpo
/// for the same cyclic strength. Settlement after liquefaction is that of [YWS06], 1.5 exp(-2.5 Dr) of the
/// shear strain, by a line beside the law (reconsolidation/compaction.hpp), and liquefied sand conducts five
/// times as well, as calibrated UBCSAND does. With n_b = 0.8 in loose sand, 0.5 from Dr = 0.55 on, CSR ~ N^-b
/// has b = 0.26 to 0.29 (3 % single amplitude, Dr from 0.35 to 0.75); with n_b = 0.5 it is 0.23 at Dr = 0.35
/// [own].
Pm4Sand calibrated_pm4sand();
Pm4Sand complete_calibrated(Pm4Sand law);

/// G0 = 167 sqrt((N1)60 + 2.5) [BZ17].
double shear_coefficient_at(double n1_60);

/// hpo for the cyclic strength of the clean-sand curve of Idriss and Boulanger (2008): a curve through this
/// program's own calibration at (N1)60 = 46 Dr^2 and the other defaults (3 % single amplitude in 15 cycles,
/// one atmosphere, K0 = 0.5). The report gives no formula.
double contraction_rate_at(double relative_density);

std::span<const LawKey<Pm4Sand>> keys_of(const Pm4Sand& law);

} // namespace quicksand
