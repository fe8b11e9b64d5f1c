#include "solver/motion/particle_motion.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/soil/ubcsand_memory.hpp"

#include <cstdint>

namespace quicksand {

namespace {

/// edge += dt L other
void add_stretch(double dt, const Gradients& L, std::size_t p, const Vectors& other, Vectors& edge)
{
    const double x = other.x[p], y = other.y[p];
    edge.x[p] += dt * (L.xx[p] * x + L.xy[p] * y);
    edge.y[p] += dt * (L.yx[p] * x + L.yy[p] * y);
}

VECTOR_KERNEL
void advance_chunk(double dt, const Vectors& grid_velocity, std::size_t first, std::size_t last,
                   Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        particles.position.x[p] += dt * grid_velocity.x[p];
        particles.position.y[p] += dt * grid_velocity.y[p];
        add_stretch(dt, L, p, particles.half_edge_1, particles.half_edge_1);
        add_stretch(dt, L, p, particles.half_edge_2, particles.half_edge_2);
        particles.volume[p] *= (1.0 + dt * L.xx[p]) * (1.0 + dt * L.yy[p]) - dt * dt * L.xy[p] * L.yx[p];
    }
}

/// The rotation of a particle in the step.
inline ubcsand::Rotation turn_of(double dt, const Gradients& L, std::size_t p)
{
    return ubcsand::rotation_of(0.5 * dt * (L.yx[p] - L.xy[p]));
}

VECTOR_KERNEL
void turn_stress(double dt, std::size_t first, std::size_t last, Particles& particles)
{
    SymmetricTensors& stress = particles.stress;
#pragma GCC ivdep
    for (std::size_t p = first; p < last; ++p) {
        const ubcsand::Rotation turn = turn_of(dt, particles.velocity_gradient_solid, p);
        const double mean = 0.5 * (stress.xx[p] + stress.yy[p]),
                     deviator = 0.5 * (stress.xx[p] - stress.yy[p]);
        const double shear = stress.xy[p];
        const double turned = turn.cosine * deviator - turn.sine * shear;
        stress.xx[p] = mean + turned;
        stress.yy[p] = mean - turned;
        stress.xy[p] = turn.sine * deviator + turn.cosine * shear;
    }
}

/// The remembered stress ratios and strains of UBCSAND turn with the stress.
VECTOR_KERNEL
void turn_memory(double dt, std::size_t first, std::size_t last, Particles& particles)
{
    CycleMemory& cycles = particles.cycles;
#pragma GCC ivdep
    for (std::size_t p = first; p < last; ++p) {
        const ubcsand::Rotation turn = turn_of(dt, particles.velocity_gradient_solid, p);
        for (Vectors* vectors : {&cycles.peak, &cycles.origin, &cycles.leg, &cycles.back})
            ubcsand::turn_vector(turn, vectors->x[p], vectors->y[p]);
    }
}

} // namespace

void advance_domains(double dt, const Vectors& grid_velocity, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        advance_chunk(dt, grid_velocity, first, last, particles);
    });
}

void displace_domains(double dt, const Vectors& grid_velocity, Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            particles.position.x[p] += dt * grid_velocity.x[p];
            particles.position.y[p] += dt * grid_velocity.y[p];
            add_stretch(dt, L, p, particles.reference_edge_1, particles.half_edge_1);
            add_stretch(dt, L, p, particles.reference_edge_2, particles.half_edge_2);
        }
    });
}

void update_porosity(const Problem& problem, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
            particles.porosity[p] =
                1.0 - particles.mass_solid[p] / (material.grain_density * particles.volume[p]);
        }
    });
}

void update_effective_stress(const Problem& problem, double dt, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        if (problem.strain == StrainForm::large) turn_stress(dt, first, last, particles);
        if (problem.strain == StrainForm::large && particles.has_cycles()) {
            turn_memory(dt, first, last, particles);
        }
        for_each_material_run(
            problem, particles, first, last,
            [&](const Material& material, std::size_t run_first, std::size_t run_last) {
                std::visit([&](const auto& law) { update_stress(law, dt, run_first, run_last, particles); },
                           material.law);
            });
    });
}

} // namespace quicksand
