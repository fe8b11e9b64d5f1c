// What laboratories know of liquefying sand, measured on a law: strength and what changes it, strain after
// liquefaction, reconsolidation, modulus and damping. Signs and frame as in specimen.hpp.
//
// Conditions  100 kPa and K0 = 1/2 where nothing else is said; strength is that of 15 uniform cycles of
// undrained
//            simple shear, to ru > 0.95, under a static shear to 3 % of shear strain if that is earlier.
#pragma once

#include "solver/element/cyclic_laboratory.hpp"

#include <array>
#include <optional>
#include <vector>

namespace quicksand {

/// Strains of the modulus and damping curves. [-]
inline constexpr std::array survey_strains = {1e-5, 1e-4, 3e-4, 1e-3};

struct ShearCurvePoint {
    double modulus_ratio; // G/Gmax [-]
    double damping_ratio; // [-]
};

struct SandSurvey {
    std::optional<CyclicStrength> strength;
    std::optional<double> k_sigma; // strength at 800 kPa over that at 100 kPa [-]
    std::optional<double> k_0;     // at K0 = 1 over that at K0 = 1/2 [-]
    std::optional<double> k_alpha; // under a static shear of 0.1 sigma'_v0 over that without [-]
    /// Largest shear strain of the cycle that reaches ru = 0.95, in 15 cycles, and of the five after it [-].
    std::vector<double> strain_of_cycles;
    double most_out_of_plane; // sigma'_z over the most of the failure limit, largest after ru = 0.95 [-]
    double reconsolidation;   // volumetric strain to 100 kPa after cycles of 8 % [-]
    double k_0_after;         // sigma'_h over sigma'_v then [-]
    std::array<ShearCurvePoint, survey_strains.size()> curve; // second cycle, drained, by survey_strains
};

SandSurvey survey(const SkeletonLaw& law);

} // namespace quicksand
