#include "solver/soil/neo_hookean.hpp"

#include "solver/soil/elastic_keys.hpp"
#include "solver/soil/linear_elastic.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace quicksand {

namespace {

LinearElastic at_small_strain(const NeoHookean& law)
{
    return {law.shear_modulus, law.poisson_ratio};
}

} // namespace

double lame_modulus(const NeoHookean& law)
{
    return lame_modulus(at_small_strain(law));
}

double constrained_modulus(const NeoHookean& law)
{
    return constrained_modulus(at_small_strain(law));
}

double shear_modulus(const NeoHookean& law)
{
    return law.shear_modulus;
}

ParticleModuli particle_moduli(const NeoHookean& law, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    // acoustic tensor along n: {[lambda (1 - ln J) + mu] n (x) n + mu (n.B n) I} / J
    const double lambda = lame_modulus(law), mu = law.shear_modulus;
    return collect_moduli(first, last, particles.volume.data(), [&](std::size_t p) {
        const Eigen::Matrix2d F = deformation_gradient(particles, p);
        const double J = F.determinant(), trace = F.squaredNorm(); // tr B
        const double largest = 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4.0 * J * J)));
        return (lambda * (1.0 - std::log(J)) + mu + mu * largest) / J;
    });
}

void update_stress(const NeoHookean& law, double, std::size_t first, std::size_t last, Particles& particles)
{
    const double lambda = lame_modulus(law), mu = law.shear_modulus;
    for (std::size_t p = first; p < last; ++p) {
        const Eigen::Matrix2d F = deformation_gradient(particles, p);
        const Eigen::Matrix2d B = F * F.transpose();
        const double J = F.determinant();
        const double volumetric = lambda * std::log(J);
        particles.stress.xx[p] = (volumetric + mu * (B(0, 0) - 1.0)) / J;
        particles.stress.yy[p] = (volumetric + mu * (B(1, 1) - 1.0)) / J;
        particles.stress.zz[p] = volumetric / J;
        particles.stress.xy[p] = mu * B(0, 1) / J;
    }
}

std::span<const LawKey<NeoHookean>> keys_of(const NeoHookean&)
{
    static constexpr std::array<LawKey<NeoHookean>, 2> keys = {{
        {shear_modulus_key, &NeoHookean::shear_modulus},
        {poisson_ratio_key, &NeoHookean::poisson_ratio},
    }};
    return keys;
}

} // namespace quicksand
