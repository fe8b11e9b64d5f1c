#include "solver/step/flowing_soil.hpp"

#include "solver/inertia/inertia_solve.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/step/cell_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double elastic_change = 0.05; // e: of the soil's stress in a step, were its strain elastic [-]
constexpr double added_inertia = 0.02;  // r: of the soil's, by its stiffness [-]

/// The stress of a particle that its soil bears, or has borne before its water took it over [Pa].
template <class Law>
double borne_stress(const Law& law, const Particles& particles, std::size_t p)
{
    const double mean = -0.5 * (particles.stress.xx[p] + particles.stress.yy[p]);
    return cohesion_of(law) + std::max({particles.initial_vertical_effective_stress[p], mean, 0.0});
}

/// Rates of work of the soil that yields, per length [W/m].
struct RatesOfWork {
    double borne = 0.0;   // of the soil's stress
    double elastic = 0.0; // of the stress that its strain in a second would cause, were it elastic
};

/// Twice the energies of the present motion, per length [J/m].
struct MotionEnergies {
    double kinetic = 0.0; // relative to the base
    double strain = 0.0;  // of the elastic strain of a second [J/(m s2)]
};

MotionEnergies energies_of_motion(const Problem& problem, const Particles& particles)
{
    MotionEnergies sum;
    const Vectors& v = particles.velocity_solid;
    const Gradients& L = particles.affine_velocity_solid;
    const auto add = [&](const Material& material, const auto& law, std::size_t first, std::size_t last) {
        const double density = mixture_density(problem, material, material.porosity);
        const double lambda_of_G = constrained_modulus(law) / shear_modulus(law) - 2.0;
        for (std::size_t p = first; p < last; ++p) {
            const double volume = particles.volume[p], expansion = L.xx[p] + L.yy[p];
            sum.kinetic += volume * density * (v.x[p] * v.x[p] + v.y[p] * v.y[p]);
            sum.strain += volume * shear_modulus_at(law, p, particles) *
                          (2.0 * rate_squared(L, p) + lambda_of_G * expansion * expansion);
        }
    };
    for_each_material_run(problem, particles, 0, particles.size(),
                          [&](const Material& material, std::size_t first, std::size_t last) {
                              std::visit([&](const auto& law) { add(material, law, first, last); },
                                         material.law);
                          });
    return sum;
}

} // namespace

double step_of_shaken_flow(const Problem& problem, const Particles& particles)
{
    const MotionEnergies sum = energies_of_motion(problem, particles);
    if (!(sum.strain > 0.0)) return std::numeric_limits<double>::infinity();
    const double of_inertia = std::sqrt(added_inertia * sum.kinetic / (inertia_fraction * sum.strain));
    return std::max(step_of_flow(problem, particles), of_inertia);
}

double step_of_flow(const Problem& problem, const Particles& particles)
{
    RatesOfWork sum;
    const auto add = [&](const auto& law, std::size_t first, std::size_t last) {
        if (!yields(law)) return;
        for (std::size_t p = first; p < last; ++p) {
            const double squared = rate_squared(particles.affine_velocity_solid, p);
            sum.borne += particles.volume[p] * borne_stress(law, particles, p) * std::sqrt(squared);
            sum.elastic += particles.volume[p] * 2.0 * shear_modulus_at(law, p, particles) * squared;
        }
    };
    for_each_material_run(problem, particles, 0, particles.size(),
                          [&](const Material& material, std::size_t first, std::size_t last) {
                              std::visit([&](const auto& law) { add(law, first, last); }, material.law);
                          });
    return sum.elastic > 0.0 ? elastic_change * sum.borne / sum.elastic
                             : std::numeric_limits<double>::infinity();
}

} // namespace quicksand
