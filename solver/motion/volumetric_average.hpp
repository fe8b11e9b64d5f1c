// One rate of volume change per cell for the stress of the grains: the cure for volumetric locking.
//
// Flow at constant volume, as of soil near failure, is more than the corners of a cell can follow at every
// particle: a mean stress that is too stiff and scatters is the result. For materials that ask for it, the
// rate of volume change at a particle is replaced by that of its cell, weighted by volume (the mean dilation
// of Nagtegaal, Parks and Rice 1974):
//   L <- L + (mean tr L - tr L) I / 2
// The stress alone sees it: shear is left as it is, and so are the motion and the velocities.
#pragma once

#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// What the average needs from step to step: nothing where no material asks for it.
struct VolumetricAverage {
    std::vector<std::uint8_t> asked_for; // by material, empty when none asks [-]
    Scalars own_xx, own_yy;              // the particles' own rates while their stress is updated [1/s]
};

VolumetricAverage make_volumetric_average(const Problem& problem);

/// update_effective_stress with the cells' rates of volume change where a material asks for them.
void update_stress_of_cells(const Problem& problem, double dt, const CellLists& lists, Particles& particles,
                            VolumetricAverage& average);

} // namespace quicksand
