// One rate of volume change per cell for the stress of the grains: the cure for volumetric locking.
//
// The nodes of a cell cannot represent flow at constant volume, as of soil near failure, at every particle:
// the response is too stiff, the mean stress oscillates. For materials with volumetric_strain = "cell", the
// rate of volume change at a particle is replaced by that of its cell, weighted by volume (the mean dilation
// of Nagtegaal, Parks and Rice 1974):
//   L <- L + (mean tr L - tr L) I / 2
// Only the stress uses this L; shear strain, motion and velocities stay. The mean stresses of particles that
// dilate go different ways, and nodal forces that work on their own rates would make energy, sum V s (tr L -
// mean tr L) of the mean stresses s in the plane: the particles of a cell in which some dilate act on the
// nodes with the mean s of those whose rates are averaged.
#pragma once

#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Flags by material [-].
struct VolumetricAverage {
    std::vector<std::uint8_t> of_strain; // whether it asks for the average; empty when none does
    std::vector<std::uint8_t> of_stress; // whether it dilates besides; empty when none does
};

VolumetricAverage make_volumetric_average(const Problem& problem);

/// Give the particles of such materials the rate of volume change of their cell in their velocity gradients.
void average_volume_change(const CellLists& lists, const VolumetricAverage& average, Particles& particles);

/// Give them the mean stress of their cell in the plane where some of it dilate.
void average_mean_stress(const CellLists& lists, const VolumetricAverage& average, Particles& particles);

} // namespace quicksand
