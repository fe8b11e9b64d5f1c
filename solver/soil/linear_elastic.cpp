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
    return {constrained_modulus(law), constrained_modulus(law)};
}

VECTOR_KERNEL
void update_stress(const LinearElastic& law, double dt, std::size_t first, std::size_t last,
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

std::span<const LawKey<LinearElastic>> keys_of(const LinearElastic&)
{
    static constexpr std::array<LawKey<LinearElastic>, 2> keys = {{
        {shear_modulus_key, &LinearElastic::shear_modulus},
        {poisson_ratio_key, &LinearElastic::poisson_ratio},
    }};
    return keys;
}

} // namespace quicksand
