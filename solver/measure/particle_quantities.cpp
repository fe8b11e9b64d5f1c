#include "solver/measure/particle_quantities.hpp"

#include "solver/measure/monitors.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

Vector2 displacement(const Particles& particles, std::size_t p)
{
    return particles.position[p] - particles.reference_position[p];
}

double total_pore_pressure(const Problem& problem, const Particles& particles, std::size_t p)
{
    if (!has_pores(problem, particles, p)) return 0.0;
    return static_water_pressure(problem, particles.position.y[p]) + excess_pore_pressure(particles, p);
}

double excess_pressure_ratio(const Problem& problem, const Particles& particles, std::size_t p)
{
    const double initial = particles.initial_vertical_effective_stress[p];
    return !has_pores(problem, particles, p) || initial < ru_stress_threshold(problem)
               ? std::numeric_limits<double>::quiet_NaN()
               : risen_pore_pressure(problem, particles, p) / initial;
}

double bounded_pressure_ratio(const Problem& problem, const Particles& particles, std::size_t p)
{
    if (!has_pores(problem, particles, p)) return 0.0;
    const double initial = particles.initial_vertical_effective_stress[p];
    return risen_pore_pressure(problem, particles, p) / std::max(initial, ru_stress_threshold(problem));
}

double mean_effective_stress(const SymmetricTensors& stress, std::size_t p)
{
    return -(stress.xx[p] + stress.yy[p] + stress.zz[p]) / 3.0;
}

double deviatoric_stress(const SymmetricTensors& stress, std::size_t p)
{
    const double mean = (stress.xx[p] + stress.yy[p] + stress.zz[p]) / 3.0;
    const double xx = stress.xx[p] - mean, yy = stress.yy[p] - mean, zz = stress.zz[p] - mean,
                 xy = stress.xy[p];
    const double j2 = 0.5 * (xx * xx + yy * yy + zz * zz) + xy * xy;
    return std::sqrt(3.0 * j2);
}

namespace {

/// s_1 - s_2 of a deformation gradient: gamma_max of the linear strain tensor of its displacements.
double stretch_difference(const Eigen::Matrix2d& gradient)
{
    // (s_1 - s_2)^2 = |F|^2 - 2 det F = (F_xx - F_yy)^2 + (F_xy + F_yx)^2, without cancellation
    return std::hypot(gradient(0, 0) - gradient(1, 1), gradient(0, 1) + gradient(1, 0));
}

} // namespace

double greatest_shear_strain(const Eigen::Matrix2d& gradient)
{
    return stretch_difference(gradient) /
           std::sqrt(std::max(gradient.determinant(), std::numeric_limits<double>::min()));
}

double greatest_shear_strain(const Problem& problem, const Particles& particles, std::size_t p)
{
    const Eigen::Matrix2d gradient = deformation_gradient(particles, p);
    return problem.strain == StrainForm::small ? stretch_difference(gradient)
                                               : greatest_shear_strain(gradient);
}

double volumetric_strain(const Problem& problem, const Particles& particles, std::size_t p)
{
    const Eigen::Matrix2d gradient = deformation_gradient(particles, p);
    return problem.strain == StrainForm::small ? gradient.trace() - 2.0 : gradient.determinant() - 1.0;
}

double largest_strain(const Problem& problem, const Particles& particles)
{
    double largest = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        largest = std::max({largest, greatest_shear_strain(problem, particles, p),
                            std::abs(volumetric_strain(problem, particles, p))});
    return largest;
}

} // namespace quicksand
