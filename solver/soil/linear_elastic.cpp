#include "solver/soil/linear_elastic.hpp"

#include "solver/base/lanes.hpp"
#include "solver/soil/elastic_keys.hpp"

#include <array>

namespace quicksand {

double lame_modulus(const LinearElastic& law)
{
    return 2.0 * law.shear_modulus * law.poisson_ratio / (1.0 - 2.0 * law.poisson_ratio);
}

double constrained_modulus(const LinearElastic& law)
{
    return lame_modulus(law) + 2.0 * law.shear_modulus;
}

double shear_modulus(const LinearElastic& law)
{
    return law.shear_modulus;
}

ParticleModuli particle_moduli(const LinearElastic& law, std::size_t, std::size_t, const Particles&)
{
    const double M = constrained_modulus(law) * unrelaxed_stiffness(law);
    return {M, M};
}

namespace {

VECTOR_KERNEL
void add_elastic(const LinearElastic& law, double dt, std::size_t first, std::size_t last,
                 Particles& particles)
{
    // d sigma' = lambda tr(d eps) I + 2 G d eps,  d eps = sym(L) dt,  d eps_zz = 0
    const double lambda = lame_modulus(law);
    const double G = law.shear_modulus;
    const Gradients& L = particles.velocity_gradient_solid;
    SymmetricTensors& stress = particles.stress;
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double volumetric = lambda * dt * (L.xx[p] + L.yy[p]);
        stress.xx[p] += volumetric + 2.0 * G * dt * L.xx[p];
        stress.yy[p] += volumetric + 2.0 * G * dt * L.yy[p];
        stress.zz[p] += volumetric;
        stress.xy[p] += G * dt * (L.xy[p] + L.yx[p]);
    }
}

} // namespace

void add_elastic_stress(const LinearElastic& law, const std::optional<MaxwellStep>& damping, double dt,
                        std::size_t first, std::size_t last, Particles& particles)
{
    if (damping)
        add_damped(*damping, lame_modulus(law), law.shear_modulus, dt, first, last, particles);
    else
        add_elastic(law, dt, first, last, particles);
}

void update_stress(const LinearElastic& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles)
{
    add_elastic_stress(law, maxwell_step_of(law, dt), dt, first, last, particles);
}

std::span<const LawKey<LinearElastic>> keys_of(const LinearElastic&)
{
    static constexpr std::array<LawKey<LinearElastic>, 4> keys = {{
        {shear_modulus_key, &LinearElastic::shear_modulus},
        {poisson_ratio_key, &LinearElastic::poisson_ratio},
        {damping_ratio_key, &LinearElastic::damping_ratio},
        {damping_frequency_key, &LinearElastic::damping_frequency},
    }};
    return keys;
}

} // namespace quicksand
