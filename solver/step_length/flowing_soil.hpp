// The step that soil in failure bears.
//
// The stiffness that resists accelerations and damps vibrations in long steps (inertia/inertia_solve.hpp) is
// elastic. Soil that flows at its strength is far softer: with the strain D dt of a step its resistance is a
// stress c 2 G D dt that nothing balances, and that stops slopes which slide. So 2 G |D| dt stays a small
// part of the stress that the soil bears, in the mean over the work of both:
//   dt <= e sum V s |D| / sum V 2 G D : D
// s: cohesion and the larger of the vertical stress at first and the mean stress. Elastic soil never flows.
// Where soil consolidates, 2 G D dt is the change of its stress in a step, and pore pressures limit it first.
//
// While something shakes it, soil that flows has waves as well. Steps may then be longer, as long as the
// stiffness of the soil adds little to its inertia, in the mean over its motion:
//   beta dt^2 sum V (2 G D : D + lambda (tr D)^2) <= r sum m v^2
// v is relative to the base. A block that slides on a band of soil accelerates by that part too little.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// Square of a particle's rate of strain, D : D [1/s2].
inline double rate_squared(const Gradients& L, std::size_t p)
{
    const double shear = L.xy[p] + L.yx[p];
    return L.xx[p] * L.xx[p] + L.yy[p] * L.yy[p] + 0.5 * shear * shear;
}

/// Longest step of the soil with its present rates of strain; infinite at rest [s].
double step_of_flow(const Problem& problem, const Particles& particles);

/// The same while something shakes it [s].
double step_of_shaken_flow(const Problem& problem, const Particles& particles);

} // namespace quicksand
