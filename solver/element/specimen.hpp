// The specimen of the element laboratory: one point of any soil law, as a particle of a run has it, strained
// at will.
//
// Units/signs  Laboratory signs: stress and strain compression positive, tau and gamma of the same sense.
// Frame        y is vertical; simple shear keeps eps_x = 0 and the plane strain eps_z = 0. Strains are
//              increments that do not turn the axes.
#pragma once

#include "solver/problem/skeleton_law.hpp"

namespace quicksand {

/// How a specimen is consolidated before its test.
struct Consolidation {
    double vertical_stress = 100e3; // sigma'_v0 [Pa]
    double k0 = 0.5;                // sigma'_h0 / sigma'_v0, horizontal in both directions [-]
    double static_shear = 0.0;      // tau_st on the horizontal plane [Pa]
};

/// The point in the apparatus with its strains.
struct Specimen {
    SkeletonLaw law;
    Particles point;                                    // one particle, the only one
    double gamma = 0.0, strain_x = 0.0, strain_y = 0.0; // since consolidation [-]
    double initial_vertical_stress = 0.0;               // sigma'_v0 [Pa]

    // effective stress [Pa]
    double sigma_x() const { return -point.stress.xx[0]; }
    double sigma_y() const { return -point.stress.yy[0]; }
    double sigma_z() const { return -point.stress.zz[0]; }
    double tau() const { return -point.stress.xy[0]; } // on the horizontal plane
};

/// A consolidated specimen, its memory as at the start of shaking. A law whose stress follows from its
/// deformation alone is strained to the stresses in the plane, and its out-of-plane stress is what follows.
/// Throws InputError when the law cannot start from the stresses.
Specimen consolidate(const SkeletonLaw& law, const Consolidation& start);

/// Whether consolidate() has a specimen for these stresses.
bool can_consolidate(const SkeletonLaw& law, const Consolidation& start);

/// Throws InputError where the law knows no mean stress as low [Pa].
void require_above_floor(const SkeletonLaw& law, double mean_stress);

void strain(double strain_x, double strain_y, double shear, Specimen& specimen);

/// M and G of unloading at the specimen's present stress [Pa].
double constrained_modulus(const Specimen& specimen);
double shear_modulus(const Specimen& specimen);

} // namespace quicksand
