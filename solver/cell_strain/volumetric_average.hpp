// One rate of volume change per cell for the stress of the grains: the cure for volumetric locking.
//
// The nodes of a cell cannot represent flow at constant volume, as of soil near failure, at every particle:
// the response is too stiff, the mean stress oscillates. For materials with volumetric_strain = "cell", the
// rate of volume change at a particle is replaced by that of its cell, weighted by volume (the mean dilation
// of Nagtegaal, Parks and Rice 1974):
//   L <- L + (mean tr L - tr L) I / 2
// Soil that dilates keeps its own rates: its particles' mean stresses go different ways, and nodal forces
// that work on the own rates would make energy, sum V s (tr L - mean tr L) of the mean stresses s in the
// plane. Only the stress uses this L; shear strain, motion and velocities stay.
#pragma once

#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// By material whether it asks for the average; empty when none does [-].
using VolumetricAverage = std::vector<std::uint8_t>;

VolumetricAverage make_volumetric_average(const Problem& problem);

/// Give the particles of such materials the rate of volume change of their cell in their velocity gradients.
/// Nothing where no material asks for it.
void average_volume_change(const CellLists& lists, const VolumetricAverage& asked_for, Particles& particles);

} // namespace quicksand
