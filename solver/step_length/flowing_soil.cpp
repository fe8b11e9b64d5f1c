#include "solver/step_length/flowing_soil.hpp"

#include "solver/base/threads.hpp"
#include "solver/inertia/inertia_solve.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/step_length/cell_extremes.hpp"

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

    RatesOfWork& operator+=(const RatesOfWork& other)
    {
        borne += other.borne;
        elastic += other.elastic;
        return *this;
    }
};

/// The same, and twice the energies of the present motion of all soil, per length [J/m].
struct RatesOfMotion {
    RatesOfWork work;
    double kinetic = 0.0; // relative to the base
    double strain = 0.0;  // of the elastic strain of a second [J/(m s2)]

    RatesOfMotion& operator+=(const RatesOfMotion& other)
    {
        work += other.work;
        kinetic += other.kinetic;
        strain += other.strain;
        return *this;
    }
};

/// The sum of add(material, law, p, sum) over the particles.
template <class Sum, class Add>
Sum sum_over_particles(const Problem& problem, const Particles& particles, Add&& add)
{
    return ordered_sum(particles.size(), Sum{}, [&](std::size_t begin, std::size_t end) {
        Sum sum;
        for_each_material_run(problem, particles, begin, end,
                              [&](const Material& material, std::size_t first, std::size_t last) {
                                  std::visit(
                                      [&](const auto& law) {
                                          for (std::size_t p = first; p < last; ++p)
                                              add(material, law, p, sum);
                                      },
                                      material.law);
                              });
        return sum;
    });
}

/// `G` is the particle's present shear modulus [Pa], `squared` that of the rate of its strain [1/s2].
template <class Law>
void add_rates_of_work(const Law& law, const Particles& particles, std::size_t p, double G, double squared,
                       RatesOfWork& sum)
{
    if (!yields(law)) return;
    sum.borne += particles.volume[p] * borne_stress(law, particles, p) * std::sqrt(squared);
    sum.elastic += particles.volume[p] * 2.0 * G * squared;
}

double step_of_flow(const RatesOfWork& sum)
{
    return sum.elastic > 0.0 ? elastic_change * sum.borne / sum.elastic
                             : std::numeric_limits<double>::infinity();
}

} // namespace

double step_of_shaken_flow(const Problem& problem, const Particles& particles)
{
    const Vectors& v = particles.velocity_solid;
    const Gradients& L = particles.affine_velocity_solid;
    const auto add = [&](const Material& material, const auto& law, std::size_t p, RatesOfMotion& sum) {
        const double volume = particles.volume[p], expansion = L.xx[p] + L.yy[p];
        const double G = shear_modulus_at(law, p, particles), squared = rate_squared(L, p);
        const double lambda_of_G = constrained_modulus(law) / shear_modulus(law) - 2.0;
        sum.kinetic += volume * mixture_density(problem, material, material.porosity) *
                       (v.x[p] * v.x[p] + v.y[p] * v.y[p]);
        sum.strain += volume * G * (2.0 * squared + lambda_of_G * expansion * expansion);
        add_rates_of_work(law, particles, p, G, squared, sum.work);
    };
    const auto sum = sum_over_particles<RatesOfMotion>(problem, particles, add);
    if (!(sum.strain > 0.0)) return std::numeric_limits<double>::infinity();
    const double of_inertia = std::sqrt(added_inertia * sum.kinetic / (inertia_fraction * sum.strain));
    return std::max(step_of_flow(sum.work), of_inertia);
}

double step_of_flow(const Problem& problem, const Particles& particles)
{
    const auto add = [&](const Material&, const auto& law, std::size_t p, RatesOfWork& sum) {
        add_rates_of_work(law, particles, p, shear_modulus_at(law, p, particles),
                          rate_squared(particles.affine_velocity_solid, p), sum);
    };
    return step_of_flow(sum_over_particles<RatesOfWork>(problem, particles, add));
}

} // namespace quicksand
