// Standing fast and slow waves of a closed column, against the Biot dispersion relation.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Relative errors of the speed (the imaginary part of the complex frequency) and the decay (its real part)
/// of the fast and of the slow wave that are one column long; where the slow wave cannot travel, its speed is
/// measured relative to its decay. One material between a base and a top that are both fixed and impervious,
/// without weight.
std::vector<StudyError> biot_waves_study(const Problem& problem, State state);

} // namespace quicksand
