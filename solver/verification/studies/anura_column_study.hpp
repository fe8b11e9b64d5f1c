// The consolidation problem with which Anura3D was measured, at the same times and in the same norms.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Errors of the pressure (L2 over the soil, relative to the load) and of the displacement of the highest
/// point (relative to the exact one there) after 0.049, 0.098, 0.196, 0.49 and 0.98 s, against Terzaghi's
/// series and against the one with inertia. The layer starts with the excess pressure of the scene, which a
/// sudden load of the same size on its top holds in balance; the effective stress starts at zero.
std::vector<StudyError> anura_column_study(const Problem& problem, State state);

} // namespace quicksand
