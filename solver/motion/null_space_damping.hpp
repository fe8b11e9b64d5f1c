// Damping of the null-space modes that deformation excites: velocities of the particles without effect on the
// nodes.
//
// In a cell that is sheared by its own size the particles have moved against each other by as much, while
// velocities are solved at the nodes only. Where waves are no faster than the deformation, the filter in time
// of grid_to_particle.hpp is too slow for these modes.
#pragma once

#include "solver/particles/particles.hpp"

namespace quicksand {

/// v <- v + theta (v_grid - v - c), theta = 4 dt |D| / (1 + 4 dt |D|), |D| the norm of the rate of strain: a
/// shear strain of a quarter reduces the modes by the factor e. `grid_velocity` is sum phi v_i, with which
/// the particles move, `mass` that with which they were scattered [kg/m]. Where theta varies, the changes of
/// neighbours do not cancel; c = sum m theta (v_grid - v) / sum m theta over all particles keeps the
/// momentum. A correction by nodes or by cells would excite the modes again. `fraction` is work space for
/// theta.
void damp_null_space_of_deformation(double dt, const Scalars& mass, const Vectors& grid_velocity,
                                    Scalars& fraction, Particles& particles);

} // namespace quicksand
