// The slopes of Griffiths and Lane (1999): strength reduction against Bishop's method of slices.
#pragma once

#include "solver/verification/solutions/griffiths_lane.hpp"
#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// The slope that the boundaries and the first material draw: one free straight face, a level crest, a fixed
/// base. Throws InputError where they draw something else, or where the material is not Mohr-Coulomb.
HomogeneousSlope slope_of(const Problem& problem);

/// Error of the factor of safety, relative to that of the critical circle.
std::vector<StudyError> griffiths_lane_study(const Problem& problem, State state);

} // namespace quicksand
