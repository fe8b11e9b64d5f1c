// A level saturated layer in shear: its resonances and its transfer function.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Relative errors of the first two resonances (free vibration from the exact mode) and of the complex motion
/// of the surface over that of the base at 0.5, 1.5 and 2.5 times the first resonance (started in the exact
/// steady state, for nothing damps what is not in it). One linear elastic material between tied sides on a
/// fixed base, saturated to a free surface; the water is dragged along by the grains.
std::vector<StudyError> shear_beam_study(const Problem& problem, State state);

} // namespace quicksand
