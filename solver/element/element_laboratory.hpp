// The element laboratory: one point of any soil law in the apparatus of a soil laboratory. The tests drive
// the same stress update as a run does. Signs and frame as in specimen.hpp.
#pragma once

#include "solver/element/specimen.hpp"

#include <vector>

namespace quicksand {

/// A state on the path of a test.
struct ElementPoint {
    double cycle = 0.0; // quarter cycles go from one peak or zero to the next [-]
    double gamma = 0.0, strain_x = 0.0, strain_y = 0.0; // since consolidation [-]
    double tau = 0.0;                                   // on the horizontal plane [Pa]
    double sigma_x = 0.0, sigma_y = 0.0, sigma_z = 0.0; // effective [Pa]
    double ru = 0.0;                                    // excess pore pressure over sigma'_v0 [-]

    double volumetric_strain() const { return strain_x + strain_y; }
    double mean_stress() const { return (sigma_x + sigma_y + sigma_z) / 3.0; } // p' [Pa]
    double deviator_stress() const;                                            // q = sqrt(3 J_2) [Pa]
};

using ElementPath = std::vector<ElementPoint>;

enum class Drainage { drained, undrained };

/// The specimen's state; ru is that of a vertical total stress which stays.
ElementPoint record(const Specimen& specimen, double cycle);

/// Simple shear to a shear strain. Undrained: at constant volume, ru = 1 - sigma'_v/sigma'_v0. Drained: at
/// constant vertical stress.
ElementPath shear_monotonically(const SkeletonLaw& law, const Consolidation& start, Drainage drainage,
                                double largest_gamma);

/// Plane-strain compression along y to a vertical strain at constant cell pressure sigma_x, which is total
/// when undrained.
ElementPath compress_biaxially(const SkeletonLaw& law, const Consolidation& start, Drainage drainage,
                               double largest_strain);

/// One-dimensional compression from one vertical stress to the next; loading and unloading.
ElementPath compress_in_oedometer(const SkeletonLaw& law, const Consolidation& start,
                                  const std::vector<double>& vertical_stresses);

/// Equal strains in x and y from one mean stress to the next.
ElementPath compress_isotropically(const SkeletonLaw& law, const Consolidation& start,
                                   const std::vector<double>& mean_stresses);

} // namespace quicksand
