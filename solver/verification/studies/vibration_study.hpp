// Large vibration of an elastic block: gravity switched on suddenly, stretches beyond two or turns of a
// radian.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// First swing of a rectangular block of one neo-Hookean material held along an edge, against finite elements
/// in the reference configuration: relative errors of the largest displacement of the point that sags most,
/// and of its time. The set-ups of the bar and the cantilever: Sadeghirad, Brannon and Burghardt 2011.
std::vector<StudyError> vibration_study(const Problem& problem, State state);

} // namespace quicksand
