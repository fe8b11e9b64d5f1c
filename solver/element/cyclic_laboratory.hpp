// Cyclic undrained simple shear in the element laboratory, and the cyclic strength that follows from it.
// Signs and frame as in specimen.hpp.
#pragma once

#include "solver/element/element_laboratory.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace quicksand {

/// Shear between tau_st - CSR sigma'_v0 and tau_st + CSR sigma'_v0, upward first.
struct StressCycles {
    double csr = 0.15;          // tau_a / sigma'_v0 [-]
    double cycles = 100.0;      // the test ends after this many, or at [-]
    double largest_gamma = 0.1; // this single-amplitude shear strain [-]
    double cycles_after = 1e9;  // after ru > 0.95 it goes on for this many only [-]
};

/// Shear between -gamma_a and gamma_a, upward first; every fourth step is a point of the path.
struct StrainCycles {
    double gamma = 0.001;                    // gamma_a [-]
    double cycles = 10.0;                    // [-]
    double steps_per_leg = 400.0;            // from peak to peak; drained at least one for 2e-5 [-]
    Drainage drainage = Drainage::undrained; // drained: at constant vertical stress
};

/// Undrained cycles between -gamma_a and gamma_a, on to the least vertical stress of the next leg, then
/// drainage: one-dimensional compression to sigma'_v0.
struct Reconsolidation {
    double gamma = 0.03;  // gamma_a [-]
    double cycles = 20.0; // [-]
};

/// Half cycles are counted at reversals: an event between the reversals 2N and 2N + 1 is at N cycles.
struct CyclicTest {
    ElementPath path;
    std::optional<double> cycles_to_ru_95;       // N to ru > 0.95 [-]
    std::optional<double> cycles_to_3_percent;   // N to |gamma| > 3 % [-]
    std::optional<double> cycles_to_375_percent; // N to |gamma| > 3.75 % [-]
    std::optional<double> cycles_to_75_double;   // N to 7.5 % from one reversal to the next [-]
    std::size_t drained_from = 0;                // point of the path from which water leaves; 0: none [-]
};

CyclicTest shear_cyclically(const SkeletonLaw& law, const Consolidation& start, const StressCycles& loading);
CyclicTest shear_cyclically(const SkeletonLaw& law, const Consolidation& start, const StrainCycles& loading);

/// `settling` is the law while water leaves, which may be another one than in the cycles: a post-shaking
/// option softens it.
CyclicTest reconsolidate(const SkeletonLaw& law, const SkeletonLaw& settling, const Consolidation& start,
                         const Reconsolidation& loading);

/// A whole cycle from the peak of one to that of the next, for modulus and damping.
struct CycleSummary {
    int cycle;             // 1, 2, ... [-]
    double gamma;          // half the peak-to-peak shear strain [-]
    double secant_modulus; // peak-to-peak stress over strain [Pa]
    double damping_ratio;  // loop area over 4 pi times the triangle below the secant [-]
    double ru;             // largest within the cycle [-]
};

std::vector<CycleSummary> summarize_cycles(const ElementPath& path);

/// A point of the cyclic strength curve.
struct StrengthPoint {
    double csr;    // [-]
    double cycles; // N to the criterion [-]
};

/// CSR that reaches the criterion in N cycles, linear in log CSR and log N between the points, which are
/// sorted by CSR; none outside their range.
std::optional<double> interpolate_csr(const std::vector<StrengthPoint>& points, double cycles);

/// CSR that reaches ru > 0.95 in N cycles, to 0.2 %. Cycles are counted in halves, so that a range of CSR has
/// the same count: its middle is taken, and log-log interpolation between the halves. None where it would be
/// below 0.01 or above 2.
std::optional<double> csr_to_ru_95(const SkeletonLaw& law, const Consolidation& start, double cycles);

/// The same to ru > 0.95 or a shear strain of 3 %, whichever comes first, as laboratories count under a
/// static shear.
std::optional<double> csr_to_liquefaction(const SkeletonLaw& law, const Consolidation& start, double cycles);

/// N to ru > 0.95 or to a shear strain of 3 %, whichever comes first; none where neither is reached.
std::optional<double> cycles_to_liquefaction(const CyclicTest& test);

/// The cyclic strength curve in two numbers.
struct CyclicStrength {
    double csr_15; // CSR to ru > 0.95 in 15 cycles [-]
    double slope;  // b of CSR ~ N^-b, from 10 to 30 cycles [-]
};

/// None where one of its CSR would be below 0.01 or above 2, as under a static shear that is never reversed,
/// and of a law without memory, for which a cycle is like the one before.
std::optional<CyclicStrength> cyclic_strength(const SkeletonLaw& law, const Consolidation& start);

} // namespace quicksand
