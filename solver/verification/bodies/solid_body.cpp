#include "solver/verification/bodies/solid_body.hpp"

#include "solver/base/failure.hpp"

#include <limits>

namespace quicksand {

SolidBody read_neo_hookean_body(const Problem& problem, const State& state)
{
    if (problem.water) throw InputError("the verification needs a dry scene, one without [water]");
    SolidBody body;
    body.lower.setConstant(std::numeric_limits<double>::infinity());
    body.upper = -body.lower;
    const Particles& particles = state.particles;
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material.front())];
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (particles.material[p] != particles.material.front()) {
            throw InputError("the verification needs a body of one material");
        }
        const Vector2 half = particles.half_edge_1[p].cwiseAbs() + particles.half_edge_2[p].cwiseAbs();
        body.lower = body.lower.cwiseMin(particles.position[p] - half);
        body.upper = body.upper.cwiseMax(particles.position[p] + half);
    }
    const NeoHookean* law = std::get_if<NeoHookean>(&material.law);
    if (!law) {
        throw InputError("the verification needs the model neo_hookean, which the material \"" +
                         material.name + "\" does not have");
    }
    body.law = *law;
    body.density = (1.0 - material.porosity) * material.grain_density;
    return body;
}

} // namespace quicksand
