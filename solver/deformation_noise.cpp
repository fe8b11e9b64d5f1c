#include "solver/deformation_noise.hpp"

#include "solver/lanes.hpp"
#include "solver/threads.hpp"

#include <cmath>

namespace quicksand {

namespace {

VECTOR_KERNEL
void fade_chunk(double dt, const Vectors& grid_velocity, std::size_t first, std::size_t last,
                Particles& particles)
{
    constexpr double fading_per_strain = 4.0; // [-]
    const Gradients& L = particles.velocity_gradient_solid;
    Vectors& velocity = particles.velocity_solid;
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double shear = 0.5 * (L.xy[p] + L.yx[p]);
        const double rate = std::sqrt(L.xx[p] * L.xx[p] + L.yy[p] * L.yy[p] + 2.0 * shear * shear);
        const double share = fading_per_strain * dt * rate / (1.0 + fading_per_strain * dt * rate);
        velocity.x[p] += share * (grid_velocity.x[p] - velocity.x[p]);
        velocity.y[p] += share * (grid_velocity.y[p] - velocity.y[p]);
    }
}

} // namespace

void fade_noise_of_deformation(double dt, const Vectors& grid_velocity, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        fade_chunk(dt, grid_velocity, first, last, particles);
    });
}

} // namespace quicksand
