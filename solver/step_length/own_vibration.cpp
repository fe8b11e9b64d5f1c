#include "solver/step_length/own_vibration.hpp"

#include "solver/base/failure.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/step_length/flowing_soil.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace quicksand {

namespace {

constexpr double first_zero = 2.405; // of J_0 [-]
// The period is then longer by 0.017 %: a hundredth of a cycle out of phase after sixty.
constexpr double steps_per_own_period = 200.0;

constexpr double periods_of_afterlife = 20.0;
// Sand neither compacts nor builds up pressures at strains of a hundred times as much.
constexpr double least_strain = 1e-6; // of a vibration [-]

double own_period(const Particles& particles, double shear_speed)
{
    return 2.0 * std::numbers::pi * body_height(particles) / (first_zero * shear_speed);
}

/// Volume of the soil that does not damp vibrations, over that of all soil [-].
double undamped_share(const Problem& problem, const Particles& particles)
{
    double undamped = 0.0, soil = 0.0;
    for_each_material_run(problem, particles, 0, particles.size(),
                          [&](const Material& material, std::size_t first, std::size_t last) {
                              if (!material.has_pores) return;
                              double volume = 0.0;
                              for (std::size_t p = first; p < last; ++p) volume += particles.volume[p];
                              soil += volume;
                              if (!damps_vibrations(material.law)) undamped += volume;
                          });
    return soil > 0.0 ? undamped / soil : 1.0;
}

double period_of_layer(const Particles& particles, double shear_slowness)
{
    return 4.0 * body_height(particles) * shear_slowness;
}

} // namespace

double body_height(const Particles& particles)
{
    ENSURE(particles.size() > 0);
    const Scalars &y = particles.position.y, &volume = particles.volume;
    const auto [lowest, highest] = std::minmax_element(y.begin(), y.end());
    const auto half_height = [&](Scalars::const_iterator at) {
        return 0.5 * std::sqrt(volume[static_cast<std::size_t>(at - y.begin())]);
    };
    return *highest + half_height(highest) - *lowest + half_height(lowest);
}

double step_of_own_vibration(const Problem& problem, const Particles& particles, double shear_speed)
{
    const double undamped = undamped_share(problem, particles);
    return undamped > 0.0 ? own_period(particles, shear_speed) / (steps_per_own_period * undamped)
                          : std::numeric_limits<double>::infinity();
}

double afterlife(const Particles& particles, double shear_slowness)
{
    return periods_of_afterlife * period_of_layer(particles, shear_slowness);
}

bool vibrates(const Particles& particles, double shear_slowness)
{
    double squared = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        squared += particles.volume[p] * rate_squared(particles.affine_velocity_solid, p);
        volume += particles.volume[p];
    }
    const double time = period_of_layer(particles, shear_slowness) / (2.0 * std::numbers::pi);
    return squared * time * time > least_strain * least_strain * volume;
}

} // namespace quicksand
