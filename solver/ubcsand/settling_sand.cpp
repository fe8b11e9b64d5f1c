#include "solver/ubcsand/settling_sand.hpp"

#include "solver/base/lanes.hpp"
#include "solver/ubcsand/ubcsand_choices.hpp"
#include "solver/ubcsand/ubcsand_particles.hpp"
#include "solver/ubcsand/ubcsand_power.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// M / G of isotropic elasticity [-].
double constrained_over_shear(const UbcSand& sand)
{
    return 2.0 * (1.0 - sand.static_poisson) / (1.0 - 2.0 * sand.static_poisson);
}

double shear_modulus_at(const UbcSand& sand, double s)
{
    return sand.G_atm * ubcsand::power(ubcsand::larger(s, sand.s_min) / atmospheric_pressure, sand.ne);
}

} // namespace

UbcSand without_weight(const UbcSand& law)
{
    UbcSand sand = law;
    sand.largest_specific_volume = sand.smallest_specific_volume = 0.0;
    return sand;
}

SettlingSand without_weight(const SettlingSand& law)
{
    return {without_weight(law.sand), 0.0};
}

SettlingSand settling_form(const UbcSand& law, double cell_weight)
{
    return {law, cell_weight};
}

SettlingSand reduced(const SettlingSand& law, double factor)
{
    SettlingSand weaker = law; // a = c cot(phi_f) stays
    weaker.sand.eta_f = std::sin(std::atan(std::tan(std::asin(law.sand.eta_f)) / factor));
    return weaker;
}

double constrained_modulus(const SettlingSand& law)
{
    return law.sand.G_atm * constrained_over_shear(law.sand);
}

double shear_modulus(const SettlingSand& law)
{
    return law.sand.G_atm;
}

VECTOR_KERNEL
ParticleModuli particle_moduli(const SettlingSand& law, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    return collect_moduli(first, last, particles.volume.data(), [&](std::size_t p) {
        const double s = -0.5 * (particles.stress.xx[p] + particles.stress.yy[p]);
        return shear_modulus_at(law.sand, s) * constrained_over_shear(law.sand);
    });
}

VECTOR_KERNEL
void update_stress(const SettlingSand& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles)
{
    // ds = (M - G) d eps_v, dq = G (d eps_xx - d eps_yy, d gamma_xy), d sigma_zz = (M - 2 G) d eps_v; t is
    // then cut back to the failure limit
    using namespace ubcsand; // its choices without branches
    const UbcSand sand = law.sand;
    const double surface_stress = law.surface_stress;
    const double M_over_G = constrained_over_shear(sand);
    const Gradients& L = particles.velocity_gradient_solid;
    SymmetricTensors& stress = particles.stress;
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double mean = -0.5 * (stress.xx[p] + stress.yy[p]); // s, compression positive
        const double G_dt = shear_modulus_at(sand, mean) * dt;
        const double volumetric = L.xx[p] + L.yy[p];
        const double s = larger(mean - (M_over_G - 1.0) * G_dt * volumetric, sand.s_min);
        const double q_x = 0.5 * (stress.xx[p] - stress.yy[p]) + G_dt * (L.xx[p] - L.yy[p]);
        const double q_y = stress.xy[p] + G_dt * (L.xy[p] + L.yx[p]);
        const double t = std::sqrt(q_x * q_x + q_y * q_y);
        const double limit = failure_shear(sand, larger(s, surface_stress));
        const double fraction = limit / larger(t, limit);
        stress.xx[p] = -s + fraction * q_x;
        stress.yy[p] = -s - fraction * q_x;
        stress.zz[p] = smaller(stress.zz[p] + (M_over_G - 2.0) * G_dt * volumetric, -0.2 * sand.s_min);
        stress.xy[p] = fraction * q_y;
    }
}

} // namespace quicksand
