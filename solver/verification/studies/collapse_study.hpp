// Dry column collapse against the scaling of Lube, Huppert, Sparks and Freundt 2005.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Runout and final height of a dry rectangular column of one Mohr-Coulomb soil between a wall and the open
/// side, on a rough floor: differences from the published laws, relative; their own scatter is about 0.1. The
/// front is where a hundredth of the soil is still ahead, the height that of the soil next to the wall.
std::vector<StudyError> collapse_study(const Problem& problem, State state);

} // namespace quicksand
