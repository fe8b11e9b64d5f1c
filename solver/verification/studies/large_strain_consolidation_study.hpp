// Consolidation of a layer that loses a large part of its height, against Xie and Leo's closed form.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Errors of the pressure (L2 over the soil, relative to the load) and of the settlement of the highest point
/// (relative to the exact one) at T = 0.1, 0.3 and 1, and of the volume ratio J (L2) at T = 1. The layer
/// is of one linear elastic material with the conductivity k_0 J^2, drained at its top, impervious at its
/// base, without weight; it starts with an excess pressure that a sudden load of the same size on its top
/// holds in balance. The closed form's water is incompressible.
std::vector<StudyError> large_strain_consolidation_study(const Problem& problem, State state);

} // namespace quicksand
