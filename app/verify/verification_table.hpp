// The table of `verify` on the terminal.
#pragma once

#include "solver/verification/solutions/convergence.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Problem, quantity, norm, errors by grid, measured order, what is required, time and reference; one line a
/// quantity, and a word where it misses what is required.
std::string describe_convergence(const std::vector<Convergence>& results);

} // namespace quicksand
