// The saturated column under a load that rises from zero, against the inverse Laplace transform of the
// coupled equations.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Over 20 equal times until twice the time that the undragged slow wave takes through the column: settlement
/// of the surface and pressure of the lowest points (L2 over the times, relative to the largest exact value),
/// and the profiles of displacement and pressure at the last time (L2 over the soil, relative to the largest
/// exact value). One material at rest, free and drained top with a load whose history starts at zero, fixed
/// and impervious base, no weight.
std::vector<StudyError> transient_column_study(const Problem& problem, State state);

} // namespace quicksand
