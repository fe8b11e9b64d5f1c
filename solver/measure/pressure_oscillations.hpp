// How noisy the pressures are, as ratios that tell locking and checkerboards from smooth fields.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

struct PressureOscillations {
    /// |sum (-1)^(i+j) p_c V_c| / sum |p_c| V_c over the cells (i, j), of the excess pore pressure and of the
    /// mean effective stress; above 0.05 neighbouring cells disagree [-].
    double pore_pressure_checkerboard = 0.0;
    double mean_stress_checkerboard = 0.0;
    /// sum V |p' - plane| / sum V |p'| of the particles' mean effective stress, where the plane goes through
    /// the mean of the particle's cell with the slope of the neighbours': about 0.01 in a smooth field,
    /// tenths where the volume of the soil locks [-].
    double mean_stress_scatter = 0.0;
};

/// Oscillations of the present state. They are zero where the mean pressure is below a thousandth of the
/// weight of half a cell of soil or water.
PressureOscillations measure_pressure_oscillations(const Problem& problem, const Particles& particles);

} // namespace quicksand
