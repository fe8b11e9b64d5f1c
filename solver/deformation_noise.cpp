#include "solver/deformation_noise.hpp"

#include "solver/threads.hpp"

#include <cmath>
#include <cstdint>

namespace quicksand {

void fade_noise_of_deformation(double dt, const Vectors& grid_velocity, Particles& particles)
{
    constexpr double fading_per_strain = 4.0; // [-]
    const Gradients& L = particles.velocity_gradient_solid;
    Vectors& velocity = particles.velocity_solid;
    const auto count = static_cast<std::int64_t>(particles.size());
#pragma omp parallel for schedule(static) if (particles.size() > least_parallel_work)
    for (std::int64_t k = 0; k < count; ++k) {
        const auto p = static_cast<std::size_t>(k);
        const double shear = 0.5 * (L.xy[p] + L.yx[p]);
        const double rate = std::sqrt(L.xx[p] * L.xx[p] + L.yy[p] * L.yy[p] + 2.0 * shear * shear);
        const double share = fading_per_strain * dt * rate / (1.0 + fading_per_strain * dt * rate);
        velocity.set(p, velocity[p] + share * (grid_velocity[p] - velocity[p]));
    }
}

} // namespace quicksand
