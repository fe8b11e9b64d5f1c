// The step of the implicit scheme, which accuracy limits and no wave.
//
// While something moves the soil (the base, loads, walls, water with a history) the step is at most
//   h / (sqrt(beta) c_s)   accelerations are smoothed over sqrt(beta) c_s dt, which is then a cell; c_s the
//                          speed of shear waves of typical soil: root of the mean of G / density by volume
//   1/200 of the period of the body itself, in soil that does not damp it (own_vibration.hpp), but not below
//                          the waves' step
//   1/200 of the period of a sine or of a ramp, the interval of a record or of a table at that time; but not
//                          below the waves' step
//   0.05                   strain of the particle that is strained fastest, but not below the waves' step
//   that in which the stiffness of soil that flows adds little to its inertia (flowing_soil.hpp), likewise
// Once nothing moves the soil any more (end_of_motion.hpp), the step starts at the limit of the waves and
// grows by a factor from step to step, as long as pore pressures change by a small part of the largest and
// the soil does not flow (flowing_soil.hpp); so it does from steps that the watchdog has made shorter, for
// pressures go on at their rate within a step.
#pragma once

#include "solver/inertia/inertia_solve.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "solver/step_length/time_step.hpp"

namespace quicksand {

inline constexpr double step_growth = 1.1;        // from step to step when nothing moves the soil any more
inline constexpr double pressure_change = 0.0125; // in a step, of the largest excess pressure [-]

/// Longest step from a time on that resolves what moves the soil; infinite where nothing varies [s].
double resolving_step(const Problem& problem, double time);

/// The same of what acts on curves alone, not of the base [s].
double resolving_step_of_histories(const Problem& problem, double time);

/// Longest step of any scheme: a twentieth of the shortest period of the sines that act at the time, without
/// which they would not be followed at all; infinite without any [s].
double coarsest_step(const Problem& problem, double time);

/// Set what the inertia of a step from the state on resists. Once nothing moves the soil any more and steps
/// grow, vibrations are not followed; they would go on for ever, as strains to and fro at the rhythm of the
/// steps, and compact sand: they are damped; so are those of solids while soil settles. Steps of a length
/// given from outside (whole_step = 0) damp nothing.
void choose_resistance(const Problem& problem, const State& state, InertiaSolve& inertia);

/// The step at a time where waves would limit it to wave_step, after one of the length last_step (0: the
/// first step) [s]; before the parts that the scene and the watchdog leave of it.
TimeStep accurate_time_step(const Problem& problem, double time, double last_step, double wave_step,
                            const Particles& particles, const CellExtremes& extremes);

} // namespace quicksand
