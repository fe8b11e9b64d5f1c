#include "solver/motion/deformation_noise.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// theta of the particles [first, last).
VECTOR_KERNEL
void set_shares(double dt, const Gradients& L, std::size_t first, std::size_t last, Scalars& share)
{
    constexpr double fading_per_strain = 4.0; // [-]
#pragma GCC ivdep                             // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double shear = 0.5 * (L.xy[p] + L.yx[p]);
        const double rate = std::sqrt(L.xx[p] * L.xx[p] + L.yy[p] * L.yy[p] + 2.0 * shear * shear);
        share[p] = fading_per_strain * dt * rate / (1.0 + fading_per_strain * dt * rate);
    }
}

/// sum m theta (v_grid - v) [N s/m] and sum m theta [kg/m].
struct FadedMomentum {
    double x = 0.0, y = 0.0, mass = 0.0;
    FadedMomentum& operator+=(const FadedMomentum& other)
    {
        x += other.x;
        y += other.y;
        mass += other.mass;
        return *this;
    }
};

FadedMomentum faded_momentum(const Scalars& share, const Scalars& mass, const Vectors& grid_velocity,
                             const Vectors& velocity)
{
    return ordered_sum<FadedMomentum>(share.size(), {}, [&](std::size_t first, std::size_t last) {
        FadedMomentum sum;
        for (std::size_t p = first; p < last; ++p) {
            const double m = mass[p] * share[p];
            sum += {m * (grid_velocity.x[p] - velocity.x[p]), m * (grid_velocity.y[p] - velocity.y[p]), m};
        }
        return sum;
    });
}

VECTOR_KERNEL
void fade_chunk(const Scalars& share, const Vectors& grid_velocity, const Vector2& common, std::size_t first,
                std::size_t last, Vectors& velocity)
{
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        velocity.x[p] += share[p] * (grid_velocity.x[p] - velocity.x[p] - common.x());
        velocity.y[p] += share[p] * (grid_velocity.y[p] - velocity.y[p] - common.y());
    }
}

} // namespace

void fade_noise_of_deformation(double dt, const Scalars& mass, const Vectors& grid_velocity, Scalars& share,
                               Particles& particles)
{
    share.resize(particles.size());
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        set_shares(dt, particles.velocity_gradient_solid, first, last, share);
    });
    const FadedMomentum faded = faded_momentum(share, mass, grid_velocity, particles.velocity_solid);
    if (faded.mass == 0.0) return;
    const Vector2 common = Vector2(faded.x, faded.y) / faded.mass;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        fade_chunk(share, grid_velocity, common, first, last, particles.velocity_solid);
    });
}

} // namespace quicksand
