#include "solver/measure/monitors.hpp"

#include "solver/base/threads.hpp"
#include "solver/interpolation/cpdi2.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

void add_phase(double mass, const Vector2& velocity, Monitors& monitors)
{
    monitors.momentum_x += mass * velocity.x();
    monitors.momentum_y += mass * velocity.y();
    monitors.kinetic_energy += 0.5 * mass * velocity.squaredNorm();
}

double water_mass(const Problem& problem, const Particles& particles, std::size_t p)
{
    const double volume = particles.water_volume.empty() ? particles.porosity[p] * particles.volume[p]
                                                         : particles.water_volume[p];
    return problem.water->density * volume;
}

void add_fluid(const Problem& problem, const Particles& particles, std::size_t p, Monitors& monitors)
{
    const double mass = water_mass(problem, particles, p);
    add_phase(mass, velocity_of_water(particles, p), monitors);
    if (!has_pores(problem, particles, p)) { // the water of its mixture is part of the solid
        monitors.mass_solid += mass;
        return;
    }
    monitors.mass_fluid += mass;
    monitors.kinetic_energy_fluid += 0.5 * mass * velocity_of_water(particles, p).squaredNorm();
    const double pressure = risen_pore_pressure(problem, particles, p);
    monitors.max_excess_pore_pressure = std::max(monitors.max_excess_pore_pressure, pressure);
    const double initial = particles.initial_vertical_effective_stress[p];
    if (initial >= ru_stress_threshold(problem))
        monitors.max_ru = std::max(monitors.max_ru, pressure / initial);
}

double crest_settlement(const Particles& particles, const std::vector<std::int32_t>& crest)
{
    if (crest.empty()) return 0.0;
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!std::binary_search(crest.begin(), crest.end(), particles.identifier[p])) continue;
        sum += particles.reference_position.y[p] - particles.position.y[p];
    }
    return sum / static_cast<double>(crest.size());
}

} // namespace

double ru_stress_threshold(const Problem& problem)
{
    constexpr double least = 1.0; // without gravity [Pa]
    if (!problem.water) return least;
    return std::max(least, 0.5 * problem.grid.cell_size * problem.water->density * problem.gravity);
}

std::vector<std::int32_t> crest_particles(const Particles& particles)
{
    double top = -std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < particles.size(); ++p) top = std::max(top, particles.position.y[p]);
    std::vector<std::int32_t> crest;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        // by its area, which stays the same when domains are kept compact: a resumed run finds the same crest
        const double quarter = 0.25 * std::sqrt(domain_area(particles, p));
        if (particles.position.y[p] > top - quarter) crest.push_back(particles.identifier[p]);
    }
    std::sort(crest.begin(), crest.end());
    return crest;
}

Monitors monitor(const Problem& problem, const State& state, const std::vector<std::int32_t>& crest)
{
    const Particles& particles = state.particles;
    Monitors monitors;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        monitors.mass_solid += particles.mass_solid[p];
        monitors.volume += particles.volume[p];
        add_phase(particles.mass_solid[p], particles.velocity_solid[p], monitors);
        monitors.max_velocity = std::max(monitors.max_velocity, particles.velocity_solid[p].norm());
        const Vector2 displacement = particles.position[p] - particles.reference_position[p];
        monitors.max_displacement = std::max(monitors.max_displacement, displacement.norm());
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        if (water_of(problem, material)) add_fluid(problem, particles, p, monitors);
    }
    monitors.crest_settlement = crest_settlement(particles, crest);
    return monitors;
}

double kinetic_energy(const Problem& problem, const Particles& particles)
{
    return ordered_sum(particles.size(), 0.0, [&](std::size_t first, std::size_t last) {
        double sum = 0.0;
        for (std::size_t p = first; p < last; ++p) {
            sum += 0.5 * particles.mass_solid[p] * particles.velocity_solid[p].squaredNorm();
            const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
            if (water_of(problem, material))
                sum +=
                    0.5 * water_mass(problem, particles, p) * velocity_of_water(particles, p).squaredNorm();
        }
        return sum;
    });
}

} // namespace quicksand
