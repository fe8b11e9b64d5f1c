// Soil as it settles under gravity, drained: sand without a memory of cycles.
//
// Sand then fails at constant volume, which the particles of a cell cannot each for itself: with volumetric
// strains of their own, slopes of sand had factors of safety that were too large by a quarter to a half. The
// strain of the cell is that of all of them (cell_strain/volumetric_average.hpp).
#pragma once

#include "solver/problem/problem.hpp"

namespace quicksand {

/// The problem while it settles, as settling_problem() of simulation.hpp, with the strength of the shaking:
/// also near the surface, where sand that settles is given that of a cell's weight.
Problem problem_at_strength(const Problem& shaken);

} // namespace quicksand
