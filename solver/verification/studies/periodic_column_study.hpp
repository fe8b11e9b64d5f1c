// The saturated column under a periodic load, against Zienkiewicz, Chang and Bettess (1980).
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Amplitude and phase along the height, of the pressure and of the displacement of the grains, over a
/// period of the load q sin(omega t) on the column's top. The run starts in the closed form's periodic state
/// and goes on until a period repeats the one before. Amplitudes: largest error, relative to the largest
/// amplitude; phases: largest error where the amplitude is above a tenth of its largest, in rad. One
/// material, free and drained top, fixed and impervious base, no weight.
std::vector<StudyError> periodic_column_study(const Problem& problem, State state);

} // namespace quicksand
