// What deformation puts into the velocities of the points that the grid cannot see, and how it fades.
//
// Points of a cell that is sheared by its own size have moved against each other by as much, with velocities
// that are known at the nodes only. The filter in time of grid_to_particle.hpp is too slow for it where waves
// are no faster than the deformation.
#pragma once

#include "solver/boundary_conditions.hpp"
#include "solver/cell_lists.hpp"
#include "solver/node_weights.hpp"
#include "solver/nodes.hpp"
#include "solver/particles.hpp"

#include <vector>

namespace quicksand {

/// Work arrays of the fading: change of the particles' velocities, and its mean at the nodes [m/s].
struct NoiseFading {
    Vectors change;
    Vectors mean;
};

/// v <- v + theta (v_grid - v), theta = 4 dt |D| / (1 + 4 dt |D|), |D| the norm of the rate of strain: a
/// quarter of a shear by the cell's size fades the noise by a factor e. `grid_velocity` is that with which
/// the particles move, sum phi v_i; `change` becomes what was added.
void fade_noise_of_deformation(double dt, const Vectors& grid_velocity, Particles& particles,
                               Vectors& change);

/// Where theta varies, the changes of neighbours do not cancel: take their mean at the nodes,
///   sum_p phi_ip m_p change_p / m_i,
/// out of the velocities again, so that momentum is kept. `mass` is that of the particles [kg/m], `sums`
/// those of the nodes with tied ones gathered.
void keep_momentum(const BackgroundGrid& grid, const CellLists& lists, const std::vector<PatchStore>& patches,
                   const NodeConditions& conditions, const Scalars& mass,
                   const std::vector<SinglePhaseSums>& sums, NoiseFading& fading, Particles& particles);

} // namespace quicksand
