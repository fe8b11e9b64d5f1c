// When nothing moves the soil with waves any more.
//
// That is the end of shaking and of all histories, but not of slow ones: what rises over a hundred times the
// time in which shear waves rise through the grid, as a flood does, moves the soil without waves. A body
// whose soil does not damp its own vibration is followed on for some periods of it after the shaking
// (own_vibration.hpp).
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

struct BodyTimes {
    double crossing = 0.0;  // in which shear waves rise from the base of the grid to its top [s]
    double afterlife = 0.0; // of the body's own vibration when the shaking is over [s]
};

/// Those of a body with the speed of shear waves `shear_speed` [m/s].
BodyTimes body_times(const Problem& problem, const Particles& particles, double shear_speed);

/// Time from which nothing moves the soil with waves any more; infinite for a sine without end [s].
double end_of_motion(const Problem& problem, const BodyTimes& body);

/// Whether that has passed.
bool is_left_alone(const Problem& problem, const State& state);

} // namespace quicksand
