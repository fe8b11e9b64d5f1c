#include "solver/motion/null_space_damping.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// theta of the particles [first, last).
VECTOR_KERNEL
void set_fractions(double dt, const Gradients& L, std::size_t first, std::size_t last, Scalars& fraction)
{
    constexpr double damping_per_strain = 4.0; // [-]
#pragma GCC ivdep                              // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double shear = 0.5 * (L.xy[p] + L.yx[p]);
        const double rate = std::sqrt(L.xx[p] * L.xx[p] + L.yy[p] * L.yy[p] + 2.0 * shear * shear);
        fraction[p] = damping_per_strain * dt * rate / (1.0 + damping_per_strain * dt * rate);
    }
}

/// sum m theta (v_grid - v) [N s/m] and sum m theta [kg/m].
struct DampedMomentum {
    double x = 0.0, y = 0.0, mass = 0.0;
    DampedMomentum& operator+=(const DampedMomentum& other)
    {
        x += other.x;
        y += other.y;
        mass += other.mass;
        return *this;
    }
};

DampedMomentum damped_momentum(const Scalars& fraction, const Scalars& mass, const Vectors& grid_velocity,
                               const Vectors& velocity)
{
    return ordered_sum<DampedMomentum>(fraction.size(), {}, [&](std::size_t first, std::size_t last) {
        DampedMomentum sum;
        for (std::size_t p = first; p < last; ++p) {
            const double m = mass[p] * fraction[p];
            sum += {m * (grid_velocity.x[p] - velocity.x[p]), m * (grid_velocity.y[p] - velocity.y[p]), m};
        }
        return sum;
    });
}

VECTOR_KERNEL
void damp_chunk(const Scalars& fraction, const Vectors& grid_velocity, const Vector2& common,
                std::size_t first, std::size_t last, Vectors& velocity)
{
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        velocity.x[p] += fraction[p] * (grid_velocity.x[p] - velocity.x[p] - common.x());
        velocity.y[p] += fraction[p] * (grid_velocity.y[p] - velocity.y[p] - common.y());
    }
}

} // namespace

void damp_null_space_of_deformation(double dt, const Scalars& mass, const Vectors& grid_velocity,
                                    Scalars& fraction, Particles& particles)
{
    fraction.resize(particles.size());
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        set_fractions(dt, particles.velocity_gradient_solid, first, last, fraction);
    });
    const DampedMomentum damped = damped_momentum(fraction, mass, grid_velocity, particles.velocity_solid);
    if (damped.mass == 0.0) return;
    const Vector2 common = Vector2(damped.x, damped.y) / damped.mass;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        damp_chunk(fraction, grid_velocity, common, first, last, particles.velocity_solid);
    });
}

} // namespace quicksand
