// Consolidation of a layer under a uniform excess pressure, against Terzaghi's series.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Errors of the pressure (L2 over the soil, relative to the initial excess pressure p_0) at T = 0.02, 0.1,
/// 0.5 and 1, against Terzaghi's series and against the one with inertia, and of the surface's settlement
/// (relative to its final one, p_0 H / M). The layer is of one material, drained at its top, impervious at
/// its base, without weight, and may lie at any angle; p_0 is uniform at the start, the effective stress in
/// balance with it and the load on the top.
std::vector<StudyError> terzaghi_study(const Problem& problem, State state);

} // namespace quicksand
