// Soil that leaves a body whose sides are one.
#pragma once

#include "solver/problem/problem.hpp"

namespace quicksand {

/// Let soil that has left a body with wrapping sides by one of them come in by the other.
void wrap_particles(const Problem& problem, Particles& particles);

} // namespace quicksand
