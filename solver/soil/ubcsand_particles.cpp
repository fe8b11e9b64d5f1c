#include "solver/soil/ubcsand_particles.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

UbcSandState at_one_atmosphere()
{
    UbcSandState state;
    state.sigma_x = state.sigma_y = state.sigma_z = atmospheric_pressure;
    return state;
}

UbcSandArrays arrays_of(Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    SymmetricTensors& stress = particles.stress;
    CycleMemory& cycles = particles.cycles;
    return {L.xx.data(),
            L.xy.data(),
            L.yx.data(),
            L.yy.data(),
            stress.xx.data(),
            stress.yy.data(),
            stress.zz.data(),
            stress.xy.data(),
            cycles.eta_max.data(),
            cycles.branch.data(),
            cycles.peak.x.data(),
            cycles.peak.y.data(),
            cycles.origin.x.data(),
            cycles.origin.y.data(),
            cycles.leg.x.data(),
            cycles.leg.y.data(),
            cycles.back.x.data(),
            cycles.back.y.data(),
            cycles.last_leg.data(),
            cycles.waiting.data(),
            cycles.half_cycles.data(),
            cycles.dilation.data(),
            cycles.active_dilation.data(),
            particles.volume.data(),
            particles.mass_solid.data()};
}

/// Shrink the deviator in the plane to the failure limit and raise the mean stress to the floor; true when
/// that changed the stress.
bool limit_stress(const UbcSand& law, UbcSandState& state)
{
    const double s_before = 0.5 * (state.sigma_x + state.sigma_y);
    const double q_x = 0.5 * (state.sigma_x - state.sigma_y), q_y = state.tau_xy;
    const double s = std::max(s_before, law.s_min), t = std::hypot(q_x, q_y);
    if (s == s_before && t <= failure_shear(law, s)) return false;
    const double ratio = t > 0.0 ? std::min(1.0, failure_shear(law, s) / t) : 1.0;
    state.sigma_x = s + ratio * q_x;
    state.sigma_y = s - ratio * q_x;
    state.tau_xy = ratio * q_y;
    return true;
}

} // namespace

double constrained_modulus(const UbcSand& law)
{
    return constrained_modulus(law, at_one_atmosphere());
}

double shear_modulus(const UbcSand& law)
{
    return shear_modulus(law, at_one_atmosphere());
}

ParticleModuli particle_moduli(const UbcSand& law, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    return particle_moduli(law, first, last, particles.stress.xx.data(), particles.stress.yy.data(),
                           particles.volume.data());
}

void update_stress(const UbcSand& law, double dt, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.has_cycles());
    update(law, dt, first, last, arrays_of(particles));
}

std::size_t start_memory(const UbcSand& law, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.has_cycles());
    const UbcSandArrays arrays = arrays_of(particles);
    std::size_t limited = 0;
    for (std::size_t p = first; p < last; ++p) {
        UbcSandState state = arrays.state(p);
        limited += limit_stress(law, state) ? 1U : 0U;
        begin_shaking(law, state);
        arrays.set(p, state);
    }
    return limited;
}

} // namespace quicksand
