// Consolidation in its first mode with conductivities over five decades, all with the same time step.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// The excess pressure p_0 cos(pi y / 2H) of a layer with a free and drained top decays with a rate that the
/// coupled equations give, inertia included. For k from 1e-2 to 1e-7 m/s: relative error of the rate over a
/// time of T = 0.1 at k = 1e-2 m/s, or four periods of the water's wave where these are longer, and the
/// largest error of the pressure at its end (L2, relative to p_0).
/// The conductivity of the problem itself is not used.
std::vector<StudyError> permeability_study(const Problem& problem, State state);

} // namespace quicksand
