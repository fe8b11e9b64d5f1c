// What deformation puts into the velocities of the points that the grid cannot see, and how it fades.
//
// Points of a cell that is sheared by its own size have moved against each other by as much, with velocities
// that are known at the nodes only. The filter in time of grid_to_particle.hpp is too slow for it where waves
// are no faster than the deformation.
#pragma once

#include "solver/particles/particles.hpp"

namespace quicksand {

/// v <- v + theta (v_grid - v - c), theta = 4 dt |D| / (1 + 4 dt |D|), |D| the norm of the rate of strain: a
/// quarter of a shear by the cell's size fades the noise by a factor e. `grid_velocity` is that with which
/// the particles move, sum phi v_i, `mass` that with which they were scattered [kg/m]. Where theta varies
/// the changes of neighbours do not cancel: c, the mean of what fades over all that deforms, sum m theta
/// (v_grid - v) / sum m theta, keeps the momentum. Given back nearer by, to nodes or cells, it would put the
/// noise back. `share` is work space.
void fade_noise_of_deformation(double dt, const Scalars& mass, const Vectors& grid_velocity, Scalars& share,
                               Particles& particles);

} // namespace quicksand
