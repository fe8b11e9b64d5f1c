// The forces of a column's stress across a vertical section, row by row of nodes.
//
//   F_j = sum_p (V_p / h) Phi_jp (sigma'_xx, sigma'_xy),     Phi_jp = sum of phi_ip over the nodes i of
//   row j
//
// over the particles of a column one cell h wide. A body of such columns has this force at the nodes of its
// side: the weights of CPDI, GIMP and linear interpolation of upright domains are products of those in x and
// y.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/step/step_workspace.hpp"
#include "solver/step/stepper.hpp"

#include <functional>

namespace quicksand {

/// Stress times volume of a column's particles, by their lasting numbers.
struct SectionStress {
    Vectors traction;     // V (sigma'_xx, sigma'_xy) [N]
    Scalars pressure;     // V p [N]
    Scalars volume;       // [m3/m]
    Scalars water_volume; // the same of the saturated particles, 0 of others [m3/m]
};

/// The stress that acts in a step from the state on; with one velocity, what settles has no pressure of its
/// own.
SectionStress section_stress(const Problem& column, const Particles& particles);

/// Set forces and heights of the rows, with places and weights of the workspace. `more_pressure(p)` is what
/// acts beyond the pressure of the state on the particle p of the workspace's order [Pa].
void find_section_forces(const Problem& column, const StepWorkspace& work, const Particles& particles,
                         const SectionStress& stress, const std::function<double(std::size_t)>& more_pressure,
                         FreeFieldRows& rows);

/// Set the velocities of the rows from the last step; rows with hardly any soil have that of the next row
/// below with soil, or of the lowest one. After find_section_forces().
void find_row_velocities(const Problem& column, const Stepper& stepper, FreeFieldRows& rows);

} // namespace quicksand
