// What is done to a consolidated specimen, in one type, and the function that does it.
// Signs and frame as in specimen.hpp.
#pragma once

#include "solver/element/cyclic_laboratory.hpp"

#include <variant>
#include <vector>

namespace quicksand {

struct MonotonicShear {
    Drainage drainage = Drainage::undrained;
    double largest_gamma = 0.1; // [-]
};

struct BiaxialCompression {
    Drainage drainage = Drainage::undrained;
    double largest_strain = 0.1; // vertical [-]
};

struct OedometerLoading {
    std::vector<double> vertical_stresses; // gone to in turn [Pa]
};

struct IsotropicLoading {
    std::vector<double> mean_stresses; // gone to in turn [Pa]
};

using ElementLoading = std::variant<StressCycles, StrainCycles, Reconsolidation, MonotonicShear,
                                    BiaxialCompression, OedometerLoading, IsotropicLoading>;

/// The path, and where the loading is cyclic its events. Throws InputError when the specimen cannot be
/// consolidated so, NumericalError when a stress cannot be held.
CyclicTest perform(const SkeletonLaw& law, const Consolidation& start, const ElementLoading& loading);

} // namespace quicksand
