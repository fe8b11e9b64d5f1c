// The stress of a step, with what the particles of a cell have in common.
#pragma once

#include "solver/motion/volumetric_average.hpp"

namespace quicksand {

/// update_effective_stress with the cells' rates of volume change for materials that ask for them, and with
/// what laws let the particles of a cell share.
void update_stress_of_cells(const Problem& problem, double dt, const CellLists& lists, Particles& particles,
                            VolumetricAverage& average);

} // namespace quicksand
