// The largest eigenvalue of the nodal equations, by iteration.
#pragma once

#include "solver/vibration/nodal_equations.hpp"

namespace quicksand {

struct LargestEigenvalue {
    double value = 0.0;  // of S K [1/s2]
    int iterations = 0;  // [-]
    Scalars eigenvector; // as velocities
};

/// Lanczos' method from a random motion that is always the same. The value is approached from below; the
/// iteration ends when three steps of it have changed the value by less than `tolerance` of it, or after
/// `max_iterations`.
LargestEigenvalue find_largest_eigenvalue(NodalEquations& equations, double tolerance, int max_iterations);

} // namespace quicksand
