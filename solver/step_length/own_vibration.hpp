// The vibration of the body itself, which shaking and loads set off, and steps that follow it.
//
// Sands damp it, for their strains lag behind at any amplitude. It lives on in soil that is elastic below
// failure, where implicit steps make its period longer, so that it runs out of phase (inertia_solve.hpp).
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/problem/problem.hpp"

namespace quicksand {

/// From the lower side of the lowest particle to the upper side of the highest, were they squares [m].
double body_height(const Particles& particles);

/// The step that has 1/200 of the body's own period where no soil damps the vibration, and more as the part
/// of the soil is larger that does; infinite where all does [s]. The period is that of the slowest shear
/// vibration of a wedge as high as the body: T = 2 pi H / (2.405 c_s), with the first zero of the Bessel
/// function J_0 and the speed of shear waves c_s, `shear_speed` [m/s]; that of a level layer, 4 H / c_s, is
/// longer.
double step_of_own_vibration(const Problem& problem, const Particles& particles, double shear_speed);

/// How long it is followed at most when nothing moves the soil any more: twenty periods of a level layer of
/// the mean slowness 1 / c_s of the body, T = 4 H / c_s, of which a soft layer has most [s].
double afterlife(const Particles& particles, double shear_slowness);

/// Whether the soil still vibrates: strained at its present rate for 1/(2 pi) of the period of a layer, it
/// would be strained by more than a millionth, the root of the mean square by volume.
bool vibrates(const Particles& particles, double shear_slowness);

} // namespace quicksand
