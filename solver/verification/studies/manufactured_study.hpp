// The manufactured solutions of large-strain elastodynamics on a scene, with every interpolation.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Largest root mean square over a period of the error of displacement, over the amplitude; infinite for an
/// interpolation that does not survive the motion. One dry
/// neo-Hookean material without weight; the motion and its body force are the study's, with the amplitude of
/// the published problem unless the parameters have another. Throws InputError where the body is not the
/// square that the motion needs.
///
/// Axis-aligned displacement, of 0.05 m as published, in a square of 1 m at the origin between rollers.
std::vector<StudyError> axis_aligned_study(const Problem& problem, State state,
                                           const StudyParameters& parameters);

/// Generalised vortex, of 0.1 (shear strains of 0.7) as published, around the middle of a fixed square of at
/// least 2.5 m.
std::vector<StudyError> vortex_study(const Problem& problem, State state, const StudyParameters& parameters);

/// The vortex of 1 (shear strains of 7): CPDI and CPDI2 up to its largest shear, CPDI over a period as well.
/// (The corners of CPDI2 follow the noise of a coarse grid until domains invert.)
std::vector<StudyError> largest_vortex_study(const Problem& problem, State state,
                                             const StudyParameters& parameters);

} // namespace quicksand
