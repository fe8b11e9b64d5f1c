#include "solver/vibration/small_motion.hpp"

#include "solver/base/threads.hpp"

#include <algorithm>

namespace quicksand {

Problem form_of_small_motion(const Problem& problem)
{
    Problem form = problem;
    form.gravity = 0.0;
    if (form.water) form.water->cavitation_pressure.reset();
    return form;
}

State resting_copy(const State& state)
{
    State copy = state;
    copy.balance_terms.reset();
    copy.free_fields.clear(); // what stands beyond the sides bears no part of the motion
    for (Vectors* velocity : {&copy.particles.velocity_solid, &copy.particles.velocity_fluid})
        for (Scalars* part : {&velocity->x, &velocity->y}) std::fill(part->begin(), part->end(), 0.0);
    return copy;
}

TangentModuli tangent_moduli(const Problem& problem, const Particles& particles)
{
    TangentModuli moduli{Scalars(particles.size()), Scalars(particles.size())};
    for_each_index(particles.size(), [&](std::size_t p) {
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        std::visit(
            [&](const auto& law) {
                const double M = particle_moduli(law, p, p + 1, particles).stiffest;
                moduli.constrained[p] = M;
                moduli.shear[p] = M * shear_modulus(law) / constrained_modulus(law);
            },
            material.law);
    });
    return moduli;
}

void set_restoring_stress(const TangentModuli& moduli, Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    SymmetricTensors& stress = particles.stress;
    for_each_index(particles.size(), [&](std::size_t p) {
        const double M = moduli.constrained[p], G = moduli.shear[p];
        const double mean = (M - 2.0 * G) * (L.xx[p] + L.yy[p]);
        stress.xx[p] = -(mean + 2.0 * G * L.xx[p]);
        stress.yy[p] = -(mean + 2.0 * G * L.yy[p]);
        stress.zz[p] = -mean;
        stress.xy[p] = -G * (L.xy[p] + L.yx[p]);
    });
}

} // namespace quicksand
