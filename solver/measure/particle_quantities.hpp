// What results tell of a particle, derived from its state: pressures, stress measures, strains.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>

namespace quicksand {

/// Displacement since the reference [m].
Vector2 displacement(const Particles& particles, std::size_t p);

/// Static plus excess pore pressure, compression positive [Pa].
double total_pore_pressure(const Problem& problem, const Particles& particles, std::size_t p);

/// r_u = excess pore pressure / sigma'_v0; NaN where sigma'_v0 is below ru_stress_threshold [-].
double excess_pressure_ratio(const Problem& problem, const Particles& particles, std::size_t p);

/// The same for averages, with sigma'_v0 at least ru_stress_threshold [-].
double bounded_pressure_ratio(const Problem& problem, const Particles& particles, std::size_t p);

/// p' = -(xx + yy + zz) / 3, compression positive [Pa].
double mean_effective_stress(const SymmetricTensors& stress, std::size_t p);

/// q = sqrt(3 J_2) [Pa].
double deviatoric_stress(const SymmetricTensors& stress, std::size_t p);

/// Greatest engineering shear strain (s_1 - s_2) / sqrt(s_1 s_2) of a deformation gradient with the singular
/// values s; gamma in simple shear [-].
double greatest_shear_strain(const Eigen::Matrix2d& gradient);

/// Greatest engineering shear strain: as above in large strain; of the linear strain tensor in small strain,
/// whose deformation gradient may have no determinant to speak of [-].
double greatest_shear_strain(const Problem& problem, const Particles& particles, std::size_t p);

/// det F - 1 in large strain, the trace of the linear strain tensor in small strain, expansion positive [-].
double volumetric_strain(const Problem& problem, const Particles& particles, std::size_t p);

/// The largest of both over all particles, by size [-].
double largest_strain(const Problem& problem, const Particles& particles);

} // namespace quicksand
