// The largest step at which the nodes' equations do not vibrate with growing amplitude.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

struct VibrationLimit {
    double dt = 0.0;                 // [s]
    Vector2 place = Vector2::Zero(); // of the node that moves most when dt is larger [m]
    int iterations = 0;              // of Lanczos' method [-]
};

/// The limit of the state of the shaking, but at most `largest` [s]. Throws NumericalError.
VibrationLimit vibration_limit(const Problem& problem, const State& state, double largest);

} // namespace quicksand
