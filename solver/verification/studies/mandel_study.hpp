// Mandel's slab between rigid plates: a pressure in the middle that rises before it falls.
#pragma once

#include "solver/verification/studies/study.hpp"

namespace quicksand {

/// Errors of the pressure at the middle (largest over time from T = 0.02 to 1, and the peak, both relative to
/// the peak), of the pressure along the slab at T = 0.05, 0.1 and 0.5 (L2, relative to the initial pressure)
/// and of the force on the plate, which is to stay constant. The scene holds a quarter of the slab: rollers
/// on its middle planes left and below, a free and drained side on the right, and the smooth impervious plate
/// on top as a curve that moves by a given normal displacement. The force is the one that gives the scene's
/// initial excess pressure; the study moves the plate as the closed form does under that force.
std::vector<StudyError> mandel_study(const Problem& problem, State state);

} // namespace quicksand
